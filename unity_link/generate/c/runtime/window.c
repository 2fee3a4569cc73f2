/* Window: exactly once, in order (docs/protocol.md, The host). --------------------------------------------------------
 *
 * Every request carries an ID. The IDs form a ring: the first one of a session is chosen when it begins, and 0 follows
 * the last one. Three marks divide the ring:
 *
 *         answered         executed, but some        sent, and            not yet
 *                          answers were lost         not confirmed        sent
 *     ----------------|------------------------|---------------------|-------------
 *                   oldest                  executed                 next
 *
 * A response to ID k, or `n k`, shows that all requests before k were executed. A posted write has no response: it was
 * executed once `executed` is after it. A fence, an `h` that follows the posted writes, shows their outcomes: its
 * response counts the failed writes of the session. If fewer errors were received than it counts, the host sends an `h`
 * with the ID of each write whose outcome is unknown, and the response repeats that outcome; the outcome of the fence
 * is reported after theirs. Until then all of them keep their places in the window, from `held` on, which is `oldest`
 * or before it.
 *
 * To *go back* is to send a session query (`K` without fields), and to retransmit the unanswered requests in order,
 * from `oldest` on. Both directions keep the order, and every sending is numbered, retransmissions and session queries
 * included. So each answer shows which earlier sendings will not be answered. If the gateway has executed all those
 * requests, only they are retransmitted; otherwise the window goes back. A damaged frame may have been the answer to
 * the oldest request, so that request alone is retransmitted; the next damaged frame is taken for the answer to the next
 * request. The unanswered requests from `to_repeat` on and before `repeat_end` are to be retransmitted.
 *
 * One loss causes several signs. After the window has gone back for one sign, it ignores further signs until something
 * has arrived that was sent since. The retransmission timeout finds a loss without a sign, or one whose session query
 * was lost. After MOST_SIGNS signs about the same request, only the timeout makes the window go back.
 *
 * A damaged request causes the loss of all requests that were sent after it. So going back lowers the send limit: to
 * half, and to at most twice the number of requests that were done since the window last went back. After that, each
 * DONE_FOR_ONE_MORE requests that are done raise the limit by one; posted writes count when they are confirmed.
 * Retransmissions obey the limit too. Answered requests do not count against it, so new requests can follow even while
 * only the oldest one is retransmitted.
 *
 * The retransmission timeout is that of RFC 6298, and at least twice the round trip. Requests that were sent twice are
 * not measured. The backoff, which doubles the timeout each time it expires, ends with the answer to a request that was
 * sent once, and with progress after a sign.
 *
 * `unity_link/protocol/window/window.py` does the same for the host in Python; tests compare the two.
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

/* Return the number of requests that have a place in the window. */
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

/* Return the unanswered request with an ID, or NULL if there is none: then the answer is a second one. */
static const ul_request *find(const ul_link *link, uint32_t id)
{
    if (distance(link, id) >= in_flight(link)) return NULL;
    const ul_request *request = &link->slots[id % UL_WINDOW];
    return request->waiting ? request : NULL;
}

/* Return the number of unfinished requests from ID `first` on and before ID `last`. */
static unsigned waiting_between(const ul_link *link, uint32_t first, uint32_t last)
{
    unsigned count = 0;
    for (; first != last; first = after(link, first)) count += link->slots[first % UL_WINDOW].waiting;
    return count;
}

/* Return the number of requests that may still be lost: not known to be executed, or executed and not answered. */
static unsigned outstanding(const ul_link *link)
{
    unsigned unknown = (link->next - link->executed) & link->ring_mask;
    return unknown + waiting_between(link, link->oldest, link->executed);
}

/* Return the ID after the first unanswered request that has a response, from an ID on; `next` if there are only
 * posted writes. */
static uint32_t behind_next_with_answer(const ul_link *link, uint32_t id)
{
    while (id != link->next) {
        const ul_request *request = find(link, id);
        id = after(link, id);
        if (request != NULL && !has_no_answer(request)) break;
    }
    return id;
}

/* Return whether sending number `one` was before `other`. The numbers wrap at 2^32; two of one window are always
 * less than 2^31 apart. */
static bool came_before(uint32_t one, uint32_t other)
{
    return one != other && other - one < UINT32_C(1) << 31;
}

/* Return the number of the last sending of a request. */
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

/* Raise the shortest retransmission timeout to a number of seconds. */
static void wait_at_least(ul_link *link, double seconds)
{
    if (link->transport.shortest_timeout < seconds) link->transport.shortest_timeout = seconds;
}

/* Start a session with its first ID. On a half-duplex medium, only one request is in flight at a time. */
static void start_window(ul_link *link, uint32_t first, double byte_time, double round_trip)
{
    uint32_t half = (link->ring_mask + 1) / 2;
    link->held = link->oldest = link->executed = link->next = first;
    link->to_repeat = link->repeat_end = link->again_end = first;
    link->next_measurement = -FOR_EVER;
    /* Sendings are numbered from 1 on. */
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

/* Return whether a destructive read would overwrite the words that the gateway keeps for an unanswered one. The
 * gateway keeps the words of a request in places from its ID on, modulo MOST_KEPT_WORDS. */
static bool would_overwrite(const ul_link *link, const ul_request *request)
{
    if (!shape_of(request->command)->is_destructive) return false;
    for (uint32_t id = link->oldest; id != link->next; id = after(link, id)) {
        const ul_request *other = find(link, id);
        if (other == NULL || !shape_of(other->command)->is_destructive) continue;
        uint32_t ahead = (link->next - id) % MOST_KEPT_WORDS, behind = (id - link->next) % MOST_KEPT_WORDS;
        /* A masked write has no count: it keeps one word. */
        if (ahead <= (other->count ? other->count - 1 : 0) || behind <= (request->count ? request->count - 1 : 0)) return true;
    }
    return false;
}

/* Return whether the answer to a request fits into one datagram together with all other answers and samples that may
 * arrive in it. A gateway does not know the largest datagram that its network carries. */
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

/* Return whether a request may be sent now. A posted write, and a request that follows one, leaves room for the
 * fence. A request longer than the gateway's whole FIFO is sent alone. */
static bool has_room(const ul_link *link, const ul_request *request)
{
    bool spares = request->posted || (link->unfenced > 0 && !shape_of(request->command)->counts);
    if (is_repeating(link) || places_held(link) + spares >= link->most_in_flight) return false;
    if (outstanding(link) + request->posted >= link->allowed || would_overwrite(link, request)) return false;
    if (!has_room_for_answer(link, request)) return false;
    if (link->byte_limit == SIZE_MAX || link->bytes == 0) return true;
    return link->bytes + request_size(link, request) * (spares ? 2 : 1) <= link->byte_limit;
}

/* Start to measure the round trip of a request that was just sent, unless another one is being measured. */
static void time_request(ul_link *link, const ul_request *request, uint32_t id, double now)
{
    if (link->is_timed || now < link->next_measurement) return;
    link->is_timed = true;
    link->timed = id;
    link->timed_at = now;
    link->timed_bytes = link->bytes;
    link->timed_reply = reply_size(link, request);
}

/* Assign the next ID to a request that is about to be sent, and return the ID. */
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

/* Return whether a fence for posted writes may be sent now. */
static bool can_fence(const ul_link *link)
{
    return link->unfenced > 0 && !is_repeating(link) && (link->awaited == 0 || has_room(link, &FENCE));
}

/* Return whether so many posted writes are unfenced that a fence must be sent now. */
static bool needs_fence(const ul_link *link)
{
    if (!can_fence(link)) return false;
    return 4 * link->unfenced >= link->allowed
        || (link->byte_limit != SIZE_MAX && 4 * link->unfenced_bytes >= link->byte_limit);
}

/* Retransmission */

/* Return the number of requests that may be retransmitted now: at least the first request with a response, and the
 * posted writes before it. */
static unsigned repetition_room(const ul_link *link)
{
    unsigned most = waiting_between(link, link->oldest, behind_next_with_answer(link, link->oldest));
    unsigned sent = waiting_between(link, link->oldest, link->to_repeat);
    if (most < link->allowed) most = link->allowed;
    return sent < most ? most - sent : 0;
}

/* Record that a request is retransmitted, and return it. */
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

/* Return the ID from which on no request was or will be retransmitted. */
static uint32_t first_sent_once(const ul_link *link)
{
    bool again = link->sent_again || is_repeating(link);
    return again && distance(link, link->again_end) <= in_flight(link) ? link->again_end : link->oldest;
}

/* Let the unanswered requests from ID `start` on and before ID `end` be retransmitted, in addition to those that are
 * due. */
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

/* Lower the send limit after a loss. */
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

/* Record that one more request is done, which may raise the send limit again. */
static void allow_more(ul_link *link)
{
    if (!link->loses) return;
    link->allowed = link->allowed_after_loss + ++link->came / DONE_FOR_ONE_MORE;
    if (link->allowed > link->most_in_flight) link->allowed = link->most_in_flight;
    link->loses = link->allowed < link->most_in_flight;
}

/* Forget the oldest `count` session queries: they were answered, or will not be. */
static void drop_questions(ul_link *link, unsigned count)
{
    link->questions -= count;
    memmove(link->question, link->question + count, link->questions * sizeof *link->question);
}

/* Record a sign that may be about the last loss or a new one. The answer to one more session query decides. */
static void doubt(ul_link *link)
{
    link->in_doubt = true;
    link->must_ask = link->questions < UL_QUESTIONS;
}

/* Record that a session query is sent. At most UL_QUESTIONS unanswered ones are recorded; the answer to a further
 * one is taken for that to an earlier one. */
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

/* Return whether a sign counts as a new loss. Until something has arrived that was sent since the window went back,
 * a sign may be about the last loss. */
static bool takes_sign(const ul_link *link)
{
    return !came_before(link->arrived, link->sign) && link->gone_back < MOST_SIGNS;
}

/* Go back because of a sign; if it may be about the last loss, ask for one more session query instead. */
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

/* Record that all sendings up to one have arrived or were lost. */
static void note_arrival(ul_link *link, uint32_t sending)
{
    unsigned over = 0;
    if (came_before(link->arrived, sending)) link->arrived = sending;
    while (over < link->questions && !came_before(sending, link->question[over])) over++;
    drop_questions(link, over);
    uint32_t ahead = distance(link, link->again_end);
    if (ahead == 0 || ahead > in_flight(link)) link->sent_again = false;
}

/* Return whether the request with an ID is unanswered, was last sent before sending `sending`, and is not to be
 * retransmitted already. */
static bool is_lost_before(const ul_link *link, uint32_t id, uint32_t sending)
{
    const ul_request *request = find(link, id);
    return request != NULL && came_before(last_sending(request), sending) && !is_to_be_repeated(link, id);
}

/* Retransmit the unanswered requests that were sent before a sending that has arrived: they or their answers were
 * lost. If the gateway has executed them, only their answers were lost, and the requests after them need no
 * retransmission. */
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

/* Received responses */

/* Move `executed` forward to an ID. */
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

/* Reset the counters of the oldest request, because another request is the oldest one now. */
static void begin_anew(ul_link *link)
{
    link->gave_up = false;
    link->gone_back = link->refusals = 0;
    /* After a timeout, the progress may be due to a late answer to an earlier sending, so the backoff stays. */
    if (!link->waited) link->timeout = link->measured_timeout;
    if (is_repeating(link) && distance(link, link->to_repeat) > in_flight(link)) {
        link->to_repeat = link->oldest;
        if (distance(link, link->repeat_end) > in_flight(link)) link->repeat_end = link->oldest;
    }
}

/* Release the places of requests whose outcomes were reported. */
static void release_places(ul_link *link)
{
    while (link->held != link->oldest && !slot_of(link, link->held)->untold) link->held = after(link, link->held);
}

/* Move `oldest` over all requests that are done, and restart the retransmission timeout. */
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

/* Use the answer to the measured request: update the round trip, and the seconds per byte if they are fewer. */
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

/* Return the number of the sending that an answer belongs to: the first one of the request after the last sending
 * that is known to have arrived. */
static uint32_t answered_sending(const ul_link *link, const ul_request *request)
{
    if (came_before(link->arrived, request->first_sending)) return request->first_sending;
    for (unsigned place = 0; place < request->sent_later; place++)
        if (came_before(link->arrived, request->later_sendings[place])) return request->later_sendings[place];
    return last_sending(request);
}

/* Process the answer to a request. If nothing was retransmitted, an answer to the oldest request shows no loss. */
static void note_answer(ul_link *link, uint32_t id, double now)
{
    ul_request *request = slot_of(link, id);
    bool may_show_losses = link->sent_again || link->questions > 0 || id != link->oldest;
    uint32_t sending = answered_sending(link, request);
    if (link->is_timed && link->timed == id) note_round_trip(link, now);
    if (request->sent_later == 0) link->timeout = link->measured_timeout;
    if (!has_no_answer(request)) link->awaited--;
    if (distance(link, id) >= distance(link, link->executed)) confirm(link, after(link, id));
    request->waiting = false;
    if (has_no_answer(request)) request->untold = false;
    allow_more(link);
    note_news(link, now);
    if (may_show_losses) find_lost(link, sending, now);
    else note_arrival(link, sending);
}

/* Process the response to a fence, which counts the failed posted writes. If as many errors were received, the
 * outcomes of all writes before the fence are known. Otherwise each of these writes is replaced by an `h` with the
 * same ID, whose response repeats the outcome of the write; `find_lost` lets these be sent, and the outcome of the
 * fence is reported after theirs. Return whether all outcomes before the fence are known. */
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

/* Process `n`: the gateway expects an ID, so a request was lost. Return false if the gateway cannot expect that ID
 * in this session: it is before `executed` or after `next`. */
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
    /* The gateway executes no later request before the lost one was retransmitted. */
    note_arrival(link, request->first_sending);
    if (takes_sign(link)) go_back(link, now);
    return true;
}

/* Process a damaged frame: perhaps the answer to the oldest request, or to the next one if the oldest one was
 * already retransmitted for an earlier damaged frame. */
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
        /* The damaged frame may have been an error or `n`; then the retransmission is not answered. */
        if (distance(link, start) >= distance(link, link->executed)) doubt(link);
    }
}

/* Process the answer to the oldest session query: requests that were sent before it will not be answered any more. */
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
    /* If a session query was lost, this was the answer to a later one. */
    if (link->in_doubt && link->questions > 0) doubt(link);
}

/* Give up the oldest request, and copy it to `given_up` so that the caller can report its outcome. An `h` takes its
 * place, because the gateway executes the later requests only after one with its ID. */
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

/* Process error 02 or 03, a refused request: after MOST_REFUSALS for the same request, give it up. Return whether
 * the gateway counts as gone, because it refuses even the `h` in the place of a request. */
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

/* Return the first ID from `refused` on whose request was first sent with, or after, the last sending of the refused
 * request. A gateway without a session refused that sending, so it executed no request from this ID on. */
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

/* Timeouts */

/* Calculate when the retransmission timeout expires. Return false if there is no deadline: posted writes have no
 * responses. */
static bool has_deadline(const ul_link *link, double *deadline)
{
    if (link->awaited == 0 && !is_repeating(link)) return false;
    /* RFC 6298 does not consider sizes: the time that the bytes need on the wire is added. */
    const ul_request *next = find(link, (behind_next_with_answer(link, link->oldest) - 1) & link->ring_mask);
    double reply = next == NULL ? 0 : (double)reply_size(link, next);
    double wire_time = link->byte_time * (double)link->bytes + link->reply_byte_time * reply;
    *deadline = link->since + link->timeout + wire_time;
    return true;
}

/* Count a timeout. If something was heard since the last one, and this was one timeout too many for the request,
 * give it up. Return whether the gateway counts as gone: it is silent, or does not answer even the `h` in the place
 * of a request. */
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

/* Go back if the retransmission timeout has expired; a request with too many timeouts is given up. Return whether
 * the gateway counts as gone. */
static bool note_time(ul_link *link, double now, ul_request *given_up)
{
    double deadline;
    if (!has_deadline(link, &deadline) || now < deadline) return false;
    /* The timeout doubles even if something was heard: that may be the beginning of a long answer on a slow line. */
    link->timeout = 2 * link->timeout < LONGEST_TIMEOUT ? 2 * link->timeout : LONGEST_TIMEOUT;
    drop_questions(link, link->questions);
    bool lost = count_try(link, now, given_up);
    link->heard = false;
    link->waited = true;
    repeat_from_oldest(link, now);
    return lost;
}
