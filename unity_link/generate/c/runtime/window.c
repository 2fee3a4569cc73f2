/* Window: exactly once, in order (docs/protocol.md, The host). --------------------------------------------------------
 *
 * Every request carries an ID, and IDs go round a ring, from that on with which the session began. Three marks stand on
 * it:
 *
 *         answered         executed, but some        sent, and            not yet
 *                          answers were lost         not confirmed        sent
 *     ----------------|------------------------|---------------------|-------------
 *                   oldest                  executed                 next
 *
 * A response to ID k, and `n k`, say that all before k were executed. Posted writes have no answer, and have been executed
 * when `executed` passes them. How they ended, an `h` behind them tells, which counts those that failed: where fewer
 * errors have come, each of them is asked for by an `h` with its ID, and the one behind them is told when they are. Until
 * then all keep their places, from `held` on, which stands at `oldest` or before it.
 *
 * To *go back* is to ask whose the session is, by a `K`, and to send what is not answered again, in order, from `oldest`
 * on. Both directions keep the order, and each sending has its place among all, repetitions and `K` among them. So what
 * has arrived says which others will not come any more: where the gateway has executed these, they alone are sent again;
 * else the window goes back. A damaged answer was perhaps that to the oldest, which alone is sent again; the next such
 * sign is about the next. `to_repeat` and `repeat_end` are the marks between which is sent again what is not answered.
 *
 * A loss brings many signs. When it was gone back for one, no further one counts before something has arrived that was
 * sent since. What brings no sign, or had its `K` lost, the time out finds; from MOST_SIGNS on for the same request it is
 * left to the time.
 *
 * One damaged request costs all those behind it. So where the window goes back, fewer are kept in flight: half as many,
 * and at most twice as many as came through since it went back before; some that are done later it is one more, and
 * posted writes count as they are confirmed. The repetition, too, sends only as many at a time. What is answered does not
 * count, so that new requests follow also where the oldest alone is sent again.
 *
 * The time out is RFC 6298's, but never less than twice the round trip. What was sent twice is not timed. The doubling is
 * undone by the answer to what was sent once, and by progress after a sign.
 *
 * It does what `unity_link/protocol/window/window.py` does, for the host in Python, and its tests compare the two.
 */

static const ul_request FENCE = {.command = "h"};
static const double FOR_EVER = 1e300;
enum { LARGEST_DATAGRAM = {{ LARGEST_DATAGRAM }}, ANSWER_RESERVE = {{ PATH.RESERVE }} };

static size_t longest_frame(const ul_link *link);

static uint32_t distance(const ul_link *link, uint32_t id)
{
    return (id - link->oldest) & link->ring_mask;
}

static unsigned in_flight(const ul_link *link)
{
    return distance(link, link->next);
}

static uint32_t after(const ul_link *link, uint32_t id)
{
    return (id + 1) & link->ring_mask;
}

/* How many requests have a place in the window. */
static unsigned places_held(const ul_link *link)
{
    return (link->next - link->held) & link->ring_mask;
}

static bool is_half_duplex(const ul_link *link)
{
    return link->info.features & UL_FEATURE_HALF_DUPLEX;
}

static bool is_repeating(const ul_link *link)
{
    return link->to_repeat != link->repeat_end;
}

static bool is_to_be_repeated(const ul_link *link, uint32_t id)
{
    return ((id - link->to_repeat) & link->ring_mask) < ((link->repeat_end - link->to_repeat) & link->ring_mask);
}

static ul_request *slot_of(ul_link *link, uint32_t id)
{
    return &link->slots[id % UL_WINDOW];
}

/* The request that an answer names, or NULL where nothing waits for it: the answer to a repetition. */
static const ul_request *find(const ul_link *link, uint32_t id)
{
    if (distance(link, id) >= in_flight(link)) return NULL;
    const ul_request *request = &link->slots[id % UL_WINDOW];
    return request->waiting ? request : NULL;
}

/* How many requests from one ID on, and before another, are not done. */
static unsigned waiting_between(const ul_link *link, uint32_t first, uint32_t last)
{
    unsigned count = 0;
    for (; first != last; first = after(link, first)) count += link->slots[first % UL_WINDOW].waiting;
    return count;
}

/* How many requests may still be lost: not known to be executed, or executed and not answered. */
static unsigned outstanding(const ul_link *link)
{
    unsigned unknown = (link->next - link->executed) & link->ring_mask;
    return unknown + waiting_between(link, link->oldest, link->executed);
}

/* The ID behind the next request that has an answer; the next one of all where there are posted writes alone. */
static uint32_t behind_next_with_answer(const ul_link *link, uint32_t id)
{
    while (id != link->next) {
        const ul_request *request = find(link, id);
        id = after(link, id);
        if (request != NULL && !has_no_answer(request)) break;
    }
    return id;
}

/* Whether one of all sendings came before another. Their places go round, but two in one window are never so far apart. */
static bool came_before(uint32_t one, uint32_t other)
{
    return one != other && other - one < UINT32_C(1) << 31;
}

/* The place of the last sending of a request. */
static uint32_t last_sending(const ul_request *request)
{
    return request->sent_later == 0 ? request->first_sending : request->later_sendings[request->sent_later - 1];
}

static void measure(ul_link *link, double round_trip)
{
    if (!link->knows_round_trip) {
        link->knows_round_trip = true;
        link->round_trip = round_trip;
        link->variation = round_trip / 2;
    } else {
        double error = link->round_trip - round_trip;
        link->variation += ((error < 0 ? -error : error) - link->variation) / 4;
        link->round_trip -= error / 8;
    }
    double spread = 4 * link->variation > link->round_trip ? 4 * link->variation : link->round_trip;
    double timeout = link->round_trip + spread;
    if (timeout < link->transport.shortest_timeout) timeout = link->transport.shortest_timeout;
    link->measured_timeout = link->timeout = timeout < LONGEST_TIMEOUT ? timeout : LONGEST_TIMEOUT;
}

/* Wait for answers so long at least. */
static void wait_at_least(ul_link *link, double seconds)
{
    if (link->transport.shortest_timeout < seconds) link->transport.shortest_timeout = seconds;
}

/* Begin a session with its first ID. Where both directions share a pair of wires, one request is under way at a time. */
static void start_window(ul_link *link, uint32_t first, double byte_time, double round_trip)
{
    uint32_t half = (link->ring_mask + 1) / 2;
    link->held = link->oldest = link->executed = link->next = first;
    link->to_repeat = link->repeat_end = link->again_end = first;
    link->next_measurement = -FOR_EVER;
    /* Places begin with 1. */
    link->sent = 1;
    link->flood_responses = UINT64_MAX;
    link->most_in_flight = is_half_duplex(link) ? 1 : half < UL_WINDOW ? half : UL_WINDOW;
    link->allowed = link->most_in_flight;
    link->byte_limit = link->info.features & UL_FEATURE_FLOW_CONTROL ? SIZE_MAX : link->info.receive_fifo_bytes;
    if (link->byte_limit != SIZE_MAX) wait_at_least(link, SHORTEST_TIMEOUT);
    if (is_half_duplex(link)) wait_at_least(link, ANSWER_PATIENCE);
    link->byte_time = link->reply_byte_time = byte_time;
    measure(link, round_trip);
}

/* Whether the gateway would keep the words of a destructive read where those of another are that is not answered. Those
 * of a request begin at its ID. */
static bool would_overwrite(const ul_link *link, const ul_request *request)
{
    if (!shape_of(request->command)->is_destructive) return false;
    for (uint32_t id = link->oldest; id != link->next; id = after(link, id)) {
        const ul_request *other = find(link, id);
        if (other == NULL || !shape_of(other->command)->is_destructive) continue;
        uint32_t ahead = (link->next - id) % MOST_KEPT_WORDS, behind = (id - link->next) % MOST_KEPT_WORDS;
        /* A masked write has no count, and one word. */
        if (ahead <= (other->count ? other->count - 1 : 0) || behind <= (request->count ? request->count - 1 : 0)) return true;
    }
    return false;
}

/* Whether the answer to a request has room in one datagram with the answers and the samples that may come with it: a
 * gateway puts them together, and does not know how long a datagram its network carries. */
static bool has_room_for_answer(const ul_link *link, const ul_request *request)
{
    size_t room = longest_frame(link) - ANSWER_RESERVE, awaited = 0;
    if (!link->transport.datagrams || link->largest_datagram == LARGEST_DATAGRAM) return true;
    for (uint32_t id = link->oldest; id != link->next; id = after(link, id)) {
        const ul_request *other = find(link, id);
        if (other != NULL) awaited += reply_size(link, other);
    }
    if (awaited == 0) return true;
    for (const ul_subscription *one = link->subscriptions; one != NULL; one = one->next)
        awaited += (size_t)one->count * link->data_digits;
    return awaited + reply_size(link, request) <= room;
}

/* Whether a request may be sent now. Posted writes, and what follows them, leave room for the `h` that confirms them, and
 * one longer than the gateway's whole FIFO goes alone. */
static bool has_room(const ul_link *link, const ul_request *request)
{
    bool spares = request->posted || (link->unfenced > 0 && !shape_of(request->command)->counts);
    if (is_repeating(link) || places_held(link) + spares >= link->most_in_flight) return false;
    if (outstanding(link) + request->posted >= link->allowed || would_overwrite(link, request)) return false;
    if (!has_room_for_answer(link, request)) return false;
    if (link->byte_limit == SIZE_MAX || link->bytes == 0) return true;
    return link->bytes + request_size(link, request) * (spares ? 2 : 1) <= link->byte_limit;
}

/* Begin to measure the round trip of a request that was just sent; one at a time. */
static void time_request(ul_link *link, const ul_request *request, uint32_t id, double now)
{
    if (link->is_timed || now < link->next_measurement) return;
    link->is_timed = true;
    link->timed = id;
    link->timed_at = now;
    link->timed_bytes = link->bytes;
    link->timed_reply = reply_size(link, request);
}

/* Give an ID to a request that is now sent. */
static uint32_t number_request(ul_link *link, const ul_request *request, double now)
{
    uint32_t id = link->next;
    size_t size = request_size(link, request);
    ul_request *slot = slot_of(link, id);
    *slot = *request;
    slot->waiting = true;
    slot->first_sending = link->sent++;
    slot->sent_later = 0;
    link->bytes += size;
    if (request->posted) link->unfenced++;
    else if (shape_of(request->command)->counts) link->unfenced = 0;
    link->unfenced_bytes = request->posted ? link->unfenced_bytes + size : 0;
    if (!request->posted) {
        link->awaited++;
        time_request(link, request, id, now);
    }
    if (link->oldest == id) link->since = now;
    link->next = after(link, id);
    return id;
}

/* Whether posted writes may be confirmed by an `h` now. */
static bool can_fence(const ul_link *link)
{
    return link->unfenced > 0 && !is_repeating(link) && (link->awaited == 0 || has_room(link, &FENCE));
}

/* Whether posted writes are so many that they need an `h` behind them. */
static bool needs_fence(const ul_link *link)
{
    if (!can_fence(link)) return false;
    return 4 * link->unfenced >= link->allowed
        || (link->byte_limit != SIZE_MAX && 4 * link->unfenced_bytes >= link->byte_limit);
}

/* Sending again */

/* How many requests may be sent again now: at least the posted writes, which nothing answers, that stand before the
 * first request with an answer, and that one. */
static unsigned repetition_room(const ul_link *link)
{
    unsigned most = waiting_between(link, link->oldest, behind_next_with_answer(link, link->oldest));
    unsigned sent = waiting_between(link, link->oldest, link->to_repeat);
    if (most < link->allowed) most = link->allowed;
    return sent < most ? most - sent : 0;
}

/* The next request is sent again. */
static const ul_request *note_repetition(ul_link *link, uint32_t id)
{
    ul_request *request = slot_of(link, id);
    if (request->sent_later == UL_SENDINGS) {
        request->sent_later--;
        memmove(request->later_sendings, request->later_sendings + 1, request->sent_later * sizeof link->sent);
    }
    request->later_sendings[request->sent_later++] = link->sent++;
    link->sent_again = true;
    return request;
}

/* The first ID from which on nothing was sent again. */
static uint32_t first_sent_once(const ul_link *link)
{
    bool again = link->sent_again || is_repeating(link);
    return again && distance(link, link->again_end) <= in_flight(link) ? link->again_end : link->oldest;
}

/* Have what is not answered from one ID on and before another sent again, besides what is to be. */
static void repeat_part(ul_link *link, uint32_t start, uint32_t end, double now)
{
    if (!is_repeating(link)) {
        link->to_repeat = start;
        link->repeat_end = end;
    } else {
        if (distance(link, start) < distance(link, link->to_repeat)) link->to_repeat = start;
        if (distance(link, end) > distance(link, link->repeat_end)) link->repeat_end = end;
    }
    end = link->repeat_end;
    link->in_doubt = link->must_ask = false;
    if (!link->sent_again || distance(link, end) > distance(link, link->again_end)) link->again_end = end;
    link->is_timed = false;
    link->since = now;
}

/* Keep fewer in flight. */
static void allow_fewer(ul_link *link)
{
    unsigned fewest = FEWEST_IN_FLIGHT < link->most_in_flight ? FEWEST_IN_FLIGHT : link->most_in_flight;
    if (link->loses && 4 * link->came < link->allowed) link->allowed = 4 * link->came;
    link->allowed /= 2;
    if (link->allowed < fewest) link->allowed = fewest;
    link->allowed_after_loss = link->allowed;
    link->loses = link->allowed < link->most_in_flight;
    link->came = 0;
}

/* Allow more again: one more is done. */
static void allow_more(ul_link *link)
{
    if (!link->loses) return;
    link->allowed = link->allowed_after_loss + ++link->came / DONE_FOR_ONE_MORE;
    if (link->allowed > link->most_in_flight) link->allowed = link->most_in_flight;
    link->loses = link->allowed < link->most_in_flight;
}

/* The oldest questions whose the session is are answered, or will not be. */
static void drop_questions(ul_link *link, unsigned count)
{
    link->questions -= count;
    memmove(link->question, link->question + count, link->questions * sizeof *link->question);
}

/* A sign has come that may be of the loss before or of the next one: one more question will tell. */
static void doubt(ul_link *link)
{
    link->in_doubt = true;
    link->must_ask = link->questions < UL_QUESTIONS;
}

/* Whose the session is is asked; where more questions than have a place are not answered, an answer counts as that to an
 * earlier one. */
static void note_question(ul_link *link)
{
    link->must_ask = false;
    if (link->questions < UL_QUESTIONS) link->question[link->questions++] = link->sent;
    link->sent++;
}

static void repeat_from_oldest(ul_link *link, double now)
{
    link->sign = link->sent;
    if (link->gone_back < MOST_SIGNS) link->gone_back++;
    allow_fewer(link);
    repeat_part(link, link->oldest, link->next, now);
}

/* Whether a sign of loss counts: as long as nothing has arrived that was sent since the window went back, it may be one of
 * the loss before. */
static bool takes_sign(const ul_link *link)
{
    return !came_before(link->arrived, link->sign) && link->gone_back < MOST_SIGNS;
}

/* Go back for a sign of loss; where it may be one of the loss before, ask how far the line has come. */
static void go_back(ul_link *link, double now)
{
    if (link->oldest == link->next) return;
    if (!takes_sign(link)) {
        doubt(link);
        return;
    }
    link->waited = false;
    repeat_from_oldest(link, now);
}

/* All up to a sending has arrived, or was lost. */
static void note_arrival(ul_link *link, uint32_t sending)
{
    unsigned over = 0;
    if (came_before(link->arrived, sending)) link->arrived = sending;
    while (over < link->questions && !came_before(sending, link->question[over])) over++;
    drop_questions(link, over);
    uint32_t ahead = distance(link, link->again_end);
    if (ahead == 0 || ahead > in_flight(link)) link->sent_again = false;
}

/* Whether a request waits for its answer, and was sent before what has arrived now. */
static bool is_lost_before(const ul_link *link, uint32_t id, uint32_t sending)
{
    const ul_request *request = find(link, id);
    return request != NULL && came_before(last_sending(request), sending) && !is_to_be_repeated(link, id);
}

/* Send again what was sent before something that has arrived, and is not answered: it or its answer was lost. Where the
 * gateway has executed it, only the answer was lost, and what is behind it is on its way. */
static void find_lost(ul_link *link, uint32_t sending, double now)
{
    note_arrival(link, sending);
    if (!link->sent_again && !is_repeating(link)) link->sign = link->arrived;
    if (!is_lost_before(link, link->oldest, sending)) return;
    link->waited = false;
    if (is_lost_before(link, link->executed, sending)) {
        repeat_from_oldest(link, now);
        return;
    }
    uint32_t end = link->oldest;
    while (end != link->executed && (find(link, end) == NULL || is_lost_before(link, end, sending))) end = after(link, end);
    repeat_part(link, link->oldest, end, now);
}

/* What arrives */

/* Move `executed` up to an ID. */
static void confirm(ul_link *link, uint32_t expected)
{
    for (; link->executed != expected; link->executed = after(link, link->executed)) {
        ul_request *request = slot_of(link, link->executed);
        if (!request->waiting) continue;
        link->bytes -= request_size(link, request);
        if (!has_no_answer(request)) continue;
        request->waiting = false;
        request->untold = true;
        allow_more(link);
    }
}

/* Begin anew with another oldest request. */
static void begin_anew(ul_link *link)
{
    link->gave_up = false;
    link->gone_back = link->refusals = 0;
    /* Where the time had run out, it may be a late answer to what was sent before. */
    if (!link->waited) link->timeout = link->measured_timeout;
    if (is_repeating(link) && distance(link, link->to_repeat) > in_flight(link)) {
        link->to_repeat = link->oldest;
        if (distance(link, link->repeat_end) > in_flight(link)) link->repeat_end = link->oldest;
    }
}

/* Give up the places of what is told. */
static void release_places(ul_link *link)
{
    while (link->held != link->oldest && !slot_of(link, link->held)->untold) link->held = after(link, link->held);
}

/* Something was confirmed: move `oldest` up over what is done, and start the clock anew. */
static void note_news(ul_link *link, double now)
{
    uint32_t before = link->oldest;
    while (link->oldest != link->executed && !slot_of(link, link->oldest)->waiting)
        link->oldest = after(link, link->oldest);
    if (link->oldest != before) begin_anew(link);
    release_places(link);
    link->tries = link->silent_tries = 0;
    link->since = now;
}

/* The answer to the request that is timed. */
static void note_round_trip(ul_link *link, double now)
{
    double round_trip = now - link->timed_at;
    double per_byte = round_trip / (double)link->timed_bytes, per_reply = round_trip / (double)link->timed_reply;
    measure(link, round_trip);
    if (per_byte < link->byte_time) link->byte_time = per_byte;
    if (per_reply < link->reply_byte_time) link->reply_byte_time = per_reply;
    link->is_timed = false;
    link->next_measurement = now + MEASUREMENT_PAUSE;
}

/* The sending that is answered now: the first behind what is known to have arrived. */
static uint32_t answered_sending(const ul_link *link, const ul_request *request)
{
    if (came_before(link->arrived, request->first_sending)) return request->first_sending;
    for (unsigned place = 0; place < request->sent_later; place++)
        if (came_before(link->arrived, request->later_sendings[place])) return request->later_sendings[place];
    return last_sending(request);
}

/* The answer to a request has come. Without repetitions, that to the oldest says nothing of the others. */
static void note_answer(ul_link *link, uint32_t id, double now)
{
    ul_request *request = slot_of(link, id);
    bool tells = link->sent_again || link->questions > 0 || id != link->oldest;
    uint32_t sending = answered_sending(link, request);
    if (link->is_timed && link->timed == id) note_round_trip(link, now);
    if (request->sent_later == 0) link->timeout = link->measured_timeout;
    if (!has_no_answer(request)) link->awaited--;
    if (distance(link, id) >= distance(link, link->executed)) confirm(link, after(link, id));
    request->waiting = false;
    if (has_no_answer(request)) request->untold = false;
    allow_more(link);
    note_news(link, now);
    if (tells) find_lost(link, sending, now);
    else note_arrival(link, sending);
}

/* An `h` says how many posted writes have failed. Where as many errors have come, those before it are told; else each is
 * asked for by an `h` with its ID, a repetition, of which the answer says how it ended. `find_lost` has these sent, and
 * this `h` is told behind them. Whether all before it are told. */
static bool note_count(ul_link *link, uint32_t fence, uint32_t failed)
{
    bool all_told = true;
    if (distance(link, fence) >= distance(link, link->executed)) confirm(link, after(link, fence));
    for (uint32_t id = link->held; id != fence; id = after(link, id)) {
        ul_request *request = slot_of(link, id);
        if (request->untold && request->posted) {
            request->untold = false;
            if (failed == link->failed) continue;
            strcpy(request->command, FENCE.command);
            request->waiting = true;
            link->awaited++;
        }
        if (!request->waiting || !request->posted) continue;
        if (all_told && distance(link, id) > in_flight(link)) link->oldest = id;
        all_told = false;
    }
    slot_of(link, fence)->untold = !all_told;
    return all_told;
}

/* `n`: the gateway expects this ID, so a request was lost. False where no gateway can expect the ID in this session: it
 * executed what lies before `executed`, and nothing was sent from `next` on. */
static bool note_gap(ul_link *link, uint32_t expected, double now)
{
    if (((expected - link->executed) & link->ring_mask) > ((link->next - link->executed) & link->ring_mask)) return false;
    if (distance(link, expected) > distance(link, link->executed)) {
        const ul_request *first = find(link, link->executed), *last = find(link, (expected - 1) & link->ring_mask);
        confirm(link, expected);
        if (first != NULL) note_arrival(link, answered_sending(link, first));
        if (last != NULL && last != first) note_arrival(link, answered_sending(link, last));
        note_news(link, now);
    }
    const ul_request *request = find(link, expected);
    if (expected != link->executed || request == NULL) return true;
    /* Nothing behind a request that was lost is executed before that was sent again. */
    note_arrival(link, request->first_sending);
    if (takes_sign(link)) go_back(link, now);
    return true;
}

/* Something arrived damaged: perhaps the answer to the oldest request, or to the next one if it came before. */
static void note_damaged_answer(ul_link *link, double now)
{
    if (!takes_sign(link)) {
        doubt(link);
        return;
    }
    uint32_t start = first_sent_once(link), end = behind_next_with_answer(link, start);
    if (start == end) {
        go_back(link, now);
    } else if (!is_to_be_repeated(link, start)) {
        link->waited = false;
        repeat_part(link, start, end, now);
        /* It may have been an error or `n`, and then there is no answer to what is sent. */
        if (distance(link, start) >= distance(link, link->executed)) doubt(link);
    }
}

/* The answer to the oldest question whose the session is: what was sent before that will not be answered any more. */
static void note_session_told(ul_link *link, double now)
{
    if (link->questions == 0) return;
    uint32_t sending = link->question[0];
    drop_questions(link, 1);
    if (link->next == link->oldest) return;
    if (link->gone_back >= MOST_SIGNS) {
        note_arrival(link, sending);
        return;
    }
    find_lost(link, sending, now);
    /* Where one was lost, this was the answer to a later one. */
    if (link->in_doubt && link->questions > 0) doubt(link);
}

/* The oldest request cannot be had. An `h` takes its place, for those behind it build on its ID; what it was is put
 * where its end can be told. */
static void give_up(ul_link *link, ul_request *given_up)
{
    ul_request *place = slot_of(link, link->oldest);
    *given_up = *place;
    strcpy(place->command, FENCE.command);
    place->address = place->count = 0;
    place->batch = NULL;
    if (has_no_answer(given_up)) link->awaited++;
    if (link->oldest == link->executed) link->bytes -= request_size(link, given_up) - request_size(link, place);
    link->tries = link->refusals = link->gone_back = 0;
    link->gave_up = true;
}

/* Error 02 or 03: once too often gives the request up. Whether the gateway is gone: where it refuses even the `h`. */
static bool note_refusal(ul_link *link, double now, ul_request *given_up)
{
    bool lost = false;
    if (link->oldest == link->next || link->oldest != link->executed || !takes_sign(link)) return false;
    if (++link->refusals == MOST_REFUSALS) {
        lost = link->gave_up;
        give_up(link, given_up);
    }
    go_back(link, now);
    return lost;
}

/* The first ID in flight that was first sent when the request that a gateway without a session refuses was sent last, or
 * later: from there on, nothing was executed. */
static uint32_t never_executed_from(const ul_link *link, uint32_t refused)
{
    const ul_request *request = find(link, refused);
    if (request == NULL) return link->next;
    uint32_t last = last_sending(request);
    while (refused != link->next && (request == NULL || came_before(request->first_sending, last))) {
        refused = after(link, refused);
        request = find(link, refused);
    }
    return refused;
}

/* Time */

/* When the time for an answer has run out; posted writes alone have none to wait for. */
static bool has_deadline(const ul_link *link, double *deadline)
{
    if (link->awaited == 0 && !is_repeating(link)) return false;
    /* RFC 6298 knows no messages of unlike sizes: the answer to a long one behind short ones is not late yet. */
    const ul_request *next = find(link, (behind_next_with_answer(link, link->oldest) - 1) & link->ring_mask);
    double reply = next == NULL ? 0 : (double)reply_size(link, next);
    double wire_time = link->byte_time * (double)link->bytes + link->reply_byte_time * reply;
    *deadline = link->since + link->timeout + wire_time;
    return true;
}

/* Count a time out; once too often gives the request up. Whether the gateway is gone: where it is silent, or not even the
 * `h` in the place of a request can be had. */
static bool count_try(ul_link *link, double now, ul_request *given_up)
{
    link->tries++;
    if (link->heard) {
        bool lost = link->gave_up;
        link->silent_tries = 0;
        if (link->tries <= MOST_TRIES) return false;
        give_up(link, given_up);
        return lost;
    }
    if (link->silent_tries++ == 0) link->silent_since = link->since;
    return link->silent_tries >= FEWEST_SILENT_TRIES && now - link->silent_since >= LONGEST_SILENCE;
}

/* Go back where the time has run out; once too often gives the request up. Whether the gateway is gone. */
static bool note_time(ul_link *link, double now, ul_request *given_up)
{
    double deadline;
    if (!has_deadline(link, &deadline) || now < deadline) return false;
    /* Also where something was heard: it may be the beginning of a long answer on a slow line. */
    link->timeout = 2 * link->timeout < LONGEST_TIMEOUT ? 2 * link->timeout : LONGEST_TIMEOUT;
    drop_questions(link, link->questions);
    bool lost = count_try(link, now, given_up);
    link->heard = false;
    link->waited = true;
    repeat_from_oldest(link, now);
    return lost;
}
