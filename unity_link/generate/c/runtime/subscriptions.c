/* Subscriptions: samples (docs/protocol.md, Groups). ------------------------------------------------------------------
 * A received sample is stored in the storage of its subscription. The program gets it from there by `ul_next`, or by
 * the callbacks of `ul_poll`. The storage of a sample has its sequence number, the number of lost samples before it,
 * its timestamp, and its words.
 */

enum { SEQUENCE, LOST, TICKS, WORDS, PERIODIC = 1, TRIGGER = 2, IMMEDIATE = 4, TIMESTAMP = 8, ON_CHANGE = 16 };
enum { MOST_DIVISOR = 65535 };

#define TURN 4294967296.0       /* number of ticks after which timestamps wrap around */
#define ROUND 256.0             /* number of samples after which sequence numbers wrap around */
#define MOST_DRIFT 200e-6       /* largest relative difference of two quartz clocks */
#define LONGEST_BUSY 200e-6     /* longest time in seconds that a sample waits for the bus */
#define MOST_ROUNDING 1e-6      /* largest relative rounding error of a rate */

/* Extend a 32-bit timestamp to 64 bits: the time nearest to an estimate by the clock of the transport. */
static uint64_t unwrap(const ul_link *link, const ul_subscription *subscription, uint32_t timestamp, double now)
{
    if (!subscription->has_sample) return timestamp;
    double passed = (now - subscription->ticked_at) * (double)link->info.clock_hz;
    uint64_t estimate = subscription->ticks + (passed > 0 ? (uint64_t)passed : 0);
    uint32_t ahead = timestamp - (uint32_t)estimate, behind = 0 - ahead;
    return ahead <= behind || behind > estimate ? estimate + ahead : estimate - behind;
}

/* Whether samples follow only the rate, so that sequence numbers determine their times. */
static bool is_timed(const ul_subscription *subscription)
{
    return subscription->has_sample && subscription->flags & TIMESTAMP
        && (subscription->flags & (PERIODIC | TRIGGER | ON_CHANGE)) == PERIODIC;
}

static double rounded(double number)
{
    return (double)(int64_t)(number < 0 ? number - 0.5 : number + 0.5);
}

/* Whether a deviation of a sample's time, in periods, is possible: the bus may have been busy when the sample was
 * due. The limit is well below half a turn of the counter. */
static bool is_near(const ul_link *link, const ul_subscription *subscription, double off, double periods)
{
    double busy = LONGEST_BUSY * subscription->actual_rate_hz, most = busy > 0.5 ? busy : 0.5;
    double turn = 0.4 * TURN / link->info.clock_hz * subscription->actual_rate_hz;
    most = (most < turn ? most : turn) + MOST_ROUNDING * periods;
    return -most <= off && off <= most;
}

/* Correct the estimate of `unwrap` by the sequence number: samples may have waited for a program that was stopped
 * for half a turn of the counter or longer. The result is the earliest time that fits sequence number and timestamp,
 * or the estimate if there is none. */
static uint64_t place(const ul_link *link, const ul_subscription *subscription, double advance, uint64_t guess,
                      double now)
{
    double hz = link->info.clock_hz, rate = subscription->actual_rate_hz, period = hz / rate;
    double due = (double)(int64_t)(guess - subscription->ticks) / period;
    if (is_near(link, subscription, due - advance, 0)) return guess;
    uint32_t first = (uint32_t)(guess - subscription->ticks);
    double most = (now - subscription->earliest) * hz - (double)subscription->ticks + TURN / 2;
    bool by_turns = ROUND * period <= TURN;
    double step = by_turns ? TURN : ROUND * period;
    for (double number = 0; number == 0 || number * step <= most; number++) {
        double turns = number, periods = (first + number * TURN) / period, off;
        if (by_turns) {
            off = periods - advance;
            off -= rounded(off / ROUND) * ROUND;
        } else {
            periods = advance + number * ROUND;
            turns = rounded((periods * period - first) / TURN);
            off = period > TURN ? 0 : (first + turns * TURN) / period - periods;
        }
        if (is_near(link, subscription, off, periods)) return subscription->ticks + first + ((uint64_t)turns << 32);
    }
    return guess;
}

/* Count the lost samples before this one. A timestamp shows how often the two digits of the sequence number wrapped. */
static uint64_t count_lost(const ul_link *link, ul_subscription *subscription, uint64_t advance, uint64_t ticks)
{
    if (is_timed(subscription)) {
        /* If the gateway's clock goes back, it is wrong, and no samples are lost. */
        double due = (double)(int64_t)(ticks - subscription->ticks) / link->info.clock_hz * subscription->actual_rate_hz;
        double rounds = (due - (double)advance) / ROUND + 0.5;
        if (rounds >= 1) advance += (uint64_t)rounds * 0x100;
    }
    subscription->sequence += advance;
    return advance - 1;
}

/* Store the time of a sample, and the earliest estimate of the time at which the gateway's clock was 0. */
static void date(const ul_link *link, ul_subscription *subscription, uint64_t ticks, double now)
{
    double earliest = subscription->earliest + MOST_DRIFT * (now - subscription->ticked_at);
    double seen = now - (double)ticks / link->info.clock_hz;
    subscription->earliest = subscription->has_sample && earliest < seen ? earliest : seen;
    subscription->ticks = ticks;
    subscription->ticked_at = now;
    subscription->has_sample = true;
}

static uint64_t *stored(const ul_subscription *subscription, size_t index)
{
    return subscription->storage + index * (WORDS + subscription->count);
}

/* The subscription that has a group; NULL if there is none. */
static ul_subscription *holder_of(const ul_link *link, uint64_t group)
{
    ul_subscription *one = link->subscriptions;
    while (one != NULL && one->actual_group != group) one = one->next;
    return one;
}

/* The number of characters in the body of a sample, from its beginning; 0 if no subscription has the group. */
static size_t sample_size(const ul_link *link, text frame)
{
    uint64_t group;
    text fields = without_first(frame, 1);
    const ul_subscription *one = take_number(&fields, 2, &group) ? holder_of(link, group) : NULL;
    if (one == NULL) return 0;
    size_t head = one->flags & TIMESTAMP ? 13 : 5;
    return head + (size_t)one->count * link->data_digits;
}

static void take_sample(ul_link *link, text body)
{
    uint64_t group, sequence, timestamp = 0, word;
    if (!take_number(&body, 2, &group) || !take_number(&body, 2, &sequence)) return;
    ul_subscription *subscription = holder_of(link, group);
    if (subscription == NULL) return;
    if (subscription->flags & TIMESTAMP && !take_number(&body, 8, &timestamp)) return;
    if (body.size != (size_t)subscription->count * link->data_digits) return;

    double now = now_of(link);
    uint64_t ticks = unwrap(link, subscription, (uint32_t)timestamp, now);
    uint64_t advance = (sequence - subscription->sequence) & 0xFF;
    if (advance == 0) advance = 0x100;
    if (is_timed(subscription)) ticks = place(link, subscription, (double)advance, ticks, now);
    uint64_t lost = count_lost(link, subscription, advance, ticks);
    date(link, subscription, ticks, now);
    subscription->received++;
    subscription->lost += lost;
    if (subscription->waiting == subscription->capacity) {
        subscription->dropped += stored(subscription, subscription->first)[LOST] + 1;
        subscription->lost++;
        subscription->first = (subscription->first + 1) % subscription->capacity;
        subscription->waiting--;
    }
    uint64_t *place = stored(subscription, (subscription->first + subscription->waiting) % subscription->capacity);
    place[SEQUENCE] = subscription->sequence;
    place[LOST] = lost;
    place[TICKS] = ticks;
    for (unsigned index = 0; index < subscription->count; index++)
        place[WORDS + index] = take_number(&body, link->data_digits, &word) ? word : 0;
    subscription->waiting++;
}

static bool give_sample(const ul_link *link, ul_subscription *subscription, ul_sample *sample)
{
    if (subscription->waiting == 0) return false;
    /* Copy the sample to a place after the others, which new samples do not overwrite. */
    uint64_t *place = stored(subscription, subscription->capacity);
    memcpy(place, stored(subscription, subscription->first), (WORDS + subscription->count) * sizeof *place);
    sample->sequence = place[SEQUENCE];
    sample->lost = place[LOST] + subscription->dropped;
    sample->time = subscription->flags & TIMESTAMP ? (double)place[TICKS] / link->info.clock_hz : 0;
    sample->words = place + WORDS;
    subscription->dropped = 0;
    subscription->first = (subscription->first + 1) % subscription->capacity;
    subscription->waiting--;
    return true;
}

static ul_status fail_plainly(ul_link *link, ul_status status)
{
    return fail(link, status, "subscription", NULL);
}

/* Check that the link is open; a link that has ended, or was never opened, receives no samples. */
static ul_status check_open(ul_link *link)
{
    if (link->open && !link->gone) return UL_OK;
    return fail_plainly(link, link->gone ? UL_LOST : UL_LOST_NOT_EXECUTED);
}

static bool is_subscribed(const ul_link *link, const ul_subscription *subscription)
{
    const ul_subscription *one = link->subscriptions;
    while (one != NULL && one != subscription) one = one->next;
    return one != NULL;
}

/* Choose the requested group, or the last free one. Samples of an earlier subscription of this group arrive before
 * the answer to `GS`, and are dropped because no subscription has the group yet. */
static ul_status choose_group(ul_link *link, ul_subscription *subscription)
{
    char reason[96];
    unsigned groups = link->info.groups, group = groups;
    if (subscription->group != 0) {
        subscription->actual_group = subscription->group - 1;
        if (subscription->group <= groups && holder_of(link, subscription->actual_group) == NULL) return UL_OK;
        snprintf(reason, sizeof reason, "group %u of the gateway is in use, or there is none", subscription->group - 1);
        return fail(link, UL_BAD_ARGUMENT, "subscription", reason);
    }
    while (group > 0 && holder_of(link, group - 1) != NULL) group--;
    subscription->actual_group = group - 1;
    if (group > 0) return UL_OK;
    snprintf(reason, sizeof reason, "all %u groups of the gateway are in use: end a subscription first", groups);
    return fail(link, UL_UNSUPPORTED, "subscription", reason);
}

/* Choose the divisor, and compute the actual rate. Returns NULL, or the fault. */
static const char *choose_rate(const ul_link *link, ul_subscription *subscription)
{
    double base = (double)link->info.base_frequency_millihertz / 1000, divisor = subscription->divisor;
    bool periodic = subscription->rate_hz > 0 || subscription->divisor > 0;
    if (subscription->divisor > MOST_DIVISOR) return "a divisor is 1 to 65535";
    if (!(subscription->rate_hz >= 0)) return "a rate is not negative";
    if (subscription->divisor == 0) divisor = periodic ? base / subscription->rate_hz : 1;
    if (subscription->nearest && divisor < 1) divisor = 1;
    if (subscription->nearest && divisor > MOST_DIVISOR) divisor = MOST_DIVISOR;
    if (divisor < 0.999999 || divisor > MOST_DIVISOR) return "the gateway has no such rate";
    subscription->actual_divisor = (unsigned)(divisor + 0.5);
    subscription->actual_rate_hz = periodic ? base / subscription->actual_divisor : 0;
    subscription->flags = periodic ? PERIODIC : 0;
    return NULL;
}

/* Compute the flags, the divisor and the number of places in the storage. Returns NULL, or the fault. */
static const char *plan(const ul_link *link, ul_subscription *subscription)
{
    unsigned features = link->info.features;
    const char *wrong = choose_rate(link, subscription);
    if (wrong != NULL) return wrong;
    if (subscription->count == 0 || subscription->count > most_in_frame(link, link->info.group_words))
        return "a group has at least one address, and at most as many as the gateway, UL_LONGEST_FRAME and the packets of "
               "the network (mtu=) allow";
    for (unsigned index = 0; index < subscription->count; index++)
        if (subscription->addresses[index] > ones(link->info.address_bits)) return "an address is beyond the gateway's";
    size_t places = subscription->storage_words / (WORDS + subscription->count);
    subscription->capacity = places - 1;
    if (subscription->storage == NULL || places < 2)
        return "storage of UL_STORAGE(samples, addresses) words is needed";
    if (subscription->trigger && !(features & UL_FEATURE_EXTERNAL_TRIGGERS))
        return "the gateway was built without external triggers";
    if (subscription->timestamps && !(features & UL_FEATURE_TIMESTAMPS))
        return "the gateway was built without timestamps";
    subscription->flags |= (subscription->trigger ? TRIGGER : 0)
        | (subscription->on_change ? ON_CHANGE : 0) | (subscription->timestamps ? TIMESTAMP : 0)
        | (subscription->immediate && features & UL_FEATURE_SEND_IMMEDIATE ? IMMEDIATE : 0);
    return NULL;
}

ul_status ul_subscribe(ul_link *link, ul_subscription *subscription)
{
    if (!link->open || link->gone) return fail_plainly(link, UL_LOST_NOT_EXECUTED);
    if (is_subscribed(link, subscription)) return fail(link, UL_BAD_ARGUMENT, "subscription", "it has begun already");
    if (!(link->info.features & UL_FEATURE_GROUPS) || link->info.groups == 0)
        return fail(link, UL_UNSUPPORTED, "subscription", "the gateway was built without groups");
    /* Change the caller's structure only if the subscription begins: it may still have samples of an earlier time. */
    ul_subscription planned = *subscription;
    const char *wrong = plan(link, &planned);
    if (wrong != NULL) return fail(link, UL_BAD_ARGUMENT, "subscription", wrong);
    ul_status status = choose_group(link, &planned);
    if (status != UL_OK) return status;

    status = ask_for(link, (ul_request){.command = "gs", .address = planned.actual_group, .word = planned.flags,
                                                  .mask = planned.actual_divisor, .count = planned.count,
                                                  .addresses = planned.addresses});
    if (status != UL_OK) return status;
    planned.sequence = UINT64_MAX;
    planned.received = planned.lost = planned.dropped = 0;
    planned.first = planned.waiting = 0;
    planned.has_sample = false;
    planned.next = link->subscriptions;
    planned.link = link;
    *subscription = planned;
    link->subscriptions = subscription;
    status = ask_for(link, (ul_request){.command = "gn", .address = planned.actual_group});
    if (status != UL_OK) ul_unsubscribe(link, subscription);
    return status;
}

ul_status ul_unsubscribe(ul_link *link, ul_subscription *subscription)
{
    ul_subscription **one = &link->subscriptions;
    if (subscription->link != NULL && subscription->link != link)
        return fail(link, UL_BAD_ARGUMENT, "subscription", "it was begun on another link, which alone ends it");
    subscription->link = NULL;
    while (*one != NULL && *one != subscription) one = &(*one)->next;
    if (*one == NULL) return UL_OK;
    *one = subscription->next;
    return link->gone ? UL_OK : ask_for(link, (ul_request){.command = "gx", .address = subscription->actual_group});
}

ul_status ul_publish(ul_link *link, ul_subscription *subscription)
{
    if (!is_subscribed(link, subscription)) return fail(link, UL_BAD_ARGUMENT, "publishing", "nothing is subscribed");
    return ask_for(link, (ul_request){.command = "gp", .address = subscription->actual_group});
}

/* Process events while only samples are expected. Posted writes are confirmed now. Samples do not show whether the
 * gateway still receives requests, or was reset; without requests in flight the session is therefore checked from
 * time to time. */
static void turn_idle(ul_link *link, double until)
{
    double due = link->since + KEEP_ALIVE;
    bool idle = in_flight(link) == 0 && link->subscriptions != NULL;
    if (can_fence(link)) send_fence(link);
    else if (idle && is_stale(link, now_of(link))) begin_proof(link);
    turn(link, idle && due < until ? due : until);
}

ul_status ul_await(ul_link *link, ul_subscription *subscription, size_t count, double seconds)
{
    double until = now_of(link) + (is_subscribed(link, subscription) ? seconds : 0);
    while (subscription->waiting < count) {
        ul_status status = check_open(link);
        if (status != UL_OK) return status;
        turn_idle(link, until);
        /* The comparison ends the loop if the time is NaN. */
        if (subscription->waiting < count && !(now_of(link) < until)) break;
    }
    flush(link);
    return subscription->waiting < count ? fail_plainly(link, UL_NO_SAMPLE) : UL_OK;
}

ul_status ul_next(ul_link *link, ul_subscription *subscription, ul_sample *sample, double seconds)
{
    ul_status status = ul_await(link, subscription, 1, seconds);
    if (status == UL_OK) give_sample(link, subscription, sample);
    return status;
}

/* Call the callbacks with the samples that are stored now. A callback may end any subscription and receive further
 * samples. Therefore each sample is searched from the beginning, and no more samples are passed than were stored at
 * first. */
static void dispatch(ul_link *link)
{
    size_t budget = 0;
    for (ul_subscription *one = link->subscriptions; one != NULL; one = one->next) budget += one->waiting;
    for (ul_subscription *one = link->subscriptions; one != NULL && budget > 0;) {
        ul_sample sample;
        if (one->callback == NULL || !give_sample(link, one, &sample)) {
            one = one->next;
            continue;
        }
        budget--;
        one->callback(one->context, &sample);
        one = link->subscriptions;
    }
}

ul_status ul_poll(ul_link *link, double seconds)
{
    double until = now_of(link) + seconds;
    do {
        ul_status status = check_open(link);
        if (status != UL_OK) return status;
        turn_idle(link, until);
        if (link->dispatching) continue;
        link->dispatching = true;
        dispatch(link);
        link->dispatching = false;
    } while (now_of(link) < until);
    flush(link);
    return UL_OK;
}
