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
 * A response to ID k, and `n k`, say that all before k were executed. Posted writes have no answer: they are done when
 * `executed` passes them. To *go back* is to send what is not answered again, from `oldest` on: of what is in flight
 * then, a reset of the gateway leaves unknown whether it was executed, unlike of what stands from `sent_once` on. While
 * the line loses, fewer requests are kept in flight, as one damaged frame costs all those behind it: half as many, and
 * at most twice as many as came through since the loss before. The repetition, too, sends only as many at a time, and
 * `to_repeat` is how far it has come. What is answered does not count, so that new requests follow also where the oldest
 * alone is sent again: where the end of a lone frame is damaged, only what follows it can show that.
 *
 * A loss brings many signs. After going back, no further one counts as long as it must still be about what was sent
 * before: for the least round trip seen, and twice as long each time; a later one says that the repetition was lost,
 * too. What brings no sign, the time out finds. Where no flow control protects the gateway's receive FIFO, only the time
 * out sends the same once more: what waits in the FIFO must have left it.
 *
 * The time out is RFC 6298's, but never less than twice the round trip. What was sent twice is not timed. The doubling is
 * undone by the answer to what was sent once, and by progress after a sign.
 */

static const ul_request FENCE = {.command = "h"};

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

static bool is_repeating(const ul_link *link)
{
    return link->to_repeat != link->next;
}

static ul_request *slot_of(ul_link *link, uint32_t id)
{
    return &link->slots[id % UL_WINDOW];
}

/* The request that an answer names, or NULL where nothing waits for it: the answer to a repetition. */
static ul_request *find(ul_link *link, uint32_t id)
{
    if (distance(link, id) >= in_flight(link)) return NULL;
    ul_request *request = slot_of(link, id);
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

static void measure(ul_link *link, double round_trip)
{
    if (!link->knows_round_trip) {
        link->knows_round_trip = true;
        link->round_trip = link->least_round_trip = round_trip;
        link->variation = round_trip / 2;
    } else {
        double error = link->round_trip - round_trip;
        link->variation += ((error < 0 ? -error : error) - link->variation) / 4;
        link->round_trip -= error / 8;
    }
    if (round_trip < link->least_round_trip) link->least_round_trip = round_trip;
    double spread = 4 * link->variation > link->round_trip ? 4 * link->variation : link->round_trip;
    double timeout = link->round_trip + spread;
    if (timeout < link->transport.shortest_timeout) timeout = link->transport.shortest_timeout;
    link->measured_timeout = link->timeout = timeout < LONGEST_TIMEOUT ? timeout : LONGEST_TIMEOUT;
}

/* Begin a session with its first ID. Where both directions share a pair of wires, one request is under way at a time. */
static void start_window(ul_link *link, uint32_t first, double byte_time, double round_trip)
{
    uint32_t half = (link->ring_mask + 1) / 2;
    link->oldest = link->executed = link->next = link->sent_once = link->to_repeat = first;
    link->most_in_flight = half < UL_WINDOW ? half : UL_WINDOW;
    if (link->info.features & UL_FEATURE_HALF_DUPLEX) link->most_in_flight = 1;
    link->allowed = link->most_in_flight;
    link->byte_limit = link->info.features & UL_FEATURE_FLOW_CONTROL ? SIZE_MAX : link->info.receive_fifo_bytes;
    if (link->byte_limit != SIZE_MAX && link->transport.shortest_timeout < SHORTEST_TIMEOUT)
        link->transport.shortest_timeout = SHORTEST_TIMEOUT;
    link->byte_time = link->reply_byte_time = byte_time;
    measure(link, round_trip);
}

/* Whether a request may be sent now. Posted writes leave room for the `h` that confirms them, and one longer than the
 * gateway's whole FIFO goes alone. */
static bool has_room(const ul_link *link, size_t size, bool posted)
{
    if (is_repeating(link) || in_flight(link) + posted >= link->most_in_flight) return false;
    if (outstanding(link) + posted >= link->allowed) return false;
    if (link->byte_limit == SIZE_MAX || link->bytes == 0) return true;
    return link->bytes + size * (posted ? 2 : 1) <= link->byte_limit;
}

/* Give an ID to a request that is now sent. */
static uint32_t number_request(ul_link *link, const ul_request *request, double now)
{
    uint32_t id = link->next;
    size_t size = request_size(link, request);
    ul_request *slot = slot_of(link, id);
    *slot = *request;
    slot->waiting = true;
    link->bytes += size;
    if (request->posted) {
        link->unfenced++;
        link->unfenced_bytes += size;
    } else {
        link->unfenced = 0;
        link->unfenced_bytes = 0;
        if (!link->is_timed && now >= link->next_measurement) {
            link->is_timed = true;
            link->timed = id;
            link->timed_at = now;
            link->timed_bytes = link->bytes;
            link->timed_reply = reply_size(link, request);
        }
    }
    if (link->oldest == id) link->since = link->silent_since = now;
    link->next = link->to_repeat = after(link, id);
    return id;
}

/* Whether posted writes may be confirmed by an `h` now. */
static bool can_fence(const ul_link *link)
{
    return link->unfenced > 0 && !is_repeating(link);
}

/* Whether posted writes are so many that they need an `h` behind them. */
static bool needs_fence(const ul_link *link)
{
    if (!can_fence(link)) return false;
    return 4 * link->unfenced >= link->allowed
        || (link->byte_limit != SIZE_MAX && 4 * link->unfenced_bytes >= link->byte_limit);
}

/* How many requests may be sent again now: at least the posted writes, which nothing answers, that stand before the
 * first request with an answer, and that one. */
static unsigned repetition_room(const ul_link *link)
{
    unsigned most = 1, sent = waiting_between(link, link->oldest, link->to_repeat);
    for (uint32_t id = link->oldest; id != link->next; id = after(link, id)) {
        const ul_request *request = &link->slots[id % UL_WINDOW];
        if (request->waiting && !request->posted) break;
        most += request->waiting;
    }
    if (most < link->allowed) most = link->allowed;
    return sent < most ? most - sent : 0;
}

static void go_back(ul_link *link, double now, bool waited)
{
    double pause = link->least_round_trip;
    if (link->gone_back >= MOST_QUICK_SIGNS && pause < SLOWER_SIGNS) pause = SLOWER_SIGNS;
    pause *= (double)(1u << link->gone_back);
    if (pause > LONGEST_TIMEOUT || link->byte_limit != SIZE_MAX) pause = LONGEST_TIMEOUT;
    link->next_sign = now + pause;
    if (link->gone_back < 2 * MOST_QUICK_SIGNS) link->gone_back++;
    link->waited = waited;
    link->refused = link->is_timed = false;
    /* Each answer has let one more be in flight. */
    unsigned fewest = FEWEST_IN_FLIGHT < link->most_in_flight ? FEWEST_IN_FLIGHT : link->most_in_flight;
    unsigned came = 2 * (link->allowed - link->allowed_after_loss), half = link->allowed / 2;
    link->allowed = came < half ? came : half;
    if (link->allowed < fewest) link->allowed = fewest;
    link->allowed_after_loss = link->allowed;
    link->to_repeat = link->oldest;
    link->sent_once = link->next;
    link->since = now;
}

/* A sign of loss, which may be one of the loss before. */
static void note_loss(ul_link *link, double now)
{
    bool has_begun = link->to_repeat != link->oldest;
    if (has_begun && (link->gone_back == 0 || now >= link->next_sign)) go_back(link, now, false);
}

/* Move `executed` up to an ID: posted writes before it are done. */
static void confirm(ul_link *link, uint32_t expected)
{
    for (; link->executed != expected; link->executed = after(link, link->executed)) {
        ul_request *request = slot_of(link, link->executed);
        if (request->waiting) link->bytes -= request_size(link, request);
        if (request->posted) request->waiting = false;
    }
}

/* Something was confirmed: move `oldest` up over what is done, and start the clock anew. */
static void note_news(ul_link *link, double now)
{
    uint32_t before = link->oldest;
    while (link->oldest != link->executed && !slot_of(link, link->oldest)->waiting) {
        uint32_t behind = after(link, link->oldest);
        if (link->sent_once == link->oldest) link->sent_once = behind;
        if (link->to_repeat == link->oldest) link->to_repeat = behind;
        link->oldest = behind;
    }
    if (link->oldest != before) {
        /* Where the time had run out, it may be a late answer to what was sent before. */
        if (!link->waited) link->timeout = link->measured_timeout;
        link->refused = link->gave_up = false;
        link->gone_back = link->refusals = 0;
    }
    link->tries = link->silent_tries = 0;
    link->since = link->silent_since = now;
}

/* The answer to a request has come. */
static void note_answer(ul_link *link, uint32_t id, double now)
{
    ul_request *request = slot_of(link, id);
    if (link->is_timed && link->timed == id) {
        double round_trip = now - link->timed_at;
        double per_byte = round_trip / (double)link->timed_bytes, per_reply = round_trip / (double)link->timed_reply;
        measure(link, round_trip);
        if (per_byte < link->byte_time) link->byte_time = per_byte;
        if (per_reply < link->reply_byte_time) link->reply_byte_time = per_reply;
        link->is_timed = false;
        link->next_measurement = now + MEASUREMENT_PAUSE;
    }
    if (link->allowed < link->most_in_flight) link->allowed++;
    if (distance(link, id) >= distance(link, link->sent_once)) link->timeout = link->measured_timeout;
    bool overtook = id != link->oldest;
    if (distance(link, id) >= distance(link, link->executed)) confirm(link, after(link, id));
    request->waiting = false;
    note_news(link, now);
    /* The answer to the oldest says nothing of those behind it, which were perhaps sent again together with it. */
    if (overtook && link->oldest != link->executed) note_loss(link, now);
}

/* `n`: the gateway expects this ID, so a request was lost. */
static void note_gap(ul_link *link, uint32_t expected, double now)
{
    if (distance(link, expected) > in_flight(link)) return;
    if (distance(link, expected) > distance(link, link->executed)) {
        confirm(link, expected);
        note_news(link, now);
    }
    note_loss(link, now);
}

/* The oldest request cannot be had. An `h` takes its place, for those behind it build on its ID; what it was is put
 * where its end can be told. Whether the gateway is gone: where not even the `h` can be had. */
static bool give_up(ul_link *link, ul_request *given_up)
{
    ul_request *place = slot_of(link, link->oldest);
    *given_up = *place;
    *place = FENCE;
    place->waiting = true;
    if (link->oldest == link->executed) link->bytes -= request_size(link, given_up) - request_size(link, place);
    bool lost = link->gave_up;
    link->tries = link->refusals = 0;
    link->gone_back = 0;
    link->gave_up = true;
    return lost;
}

/* Error 02 or 03: once too often gives the request up. Whether the gateway is gone. */
static bool note_refusal(ul_link *link, double now, ul_request *given_up)
{
    bool lost = false;
    if (link->oldest != link->next && link->oldest == link->executed && !link->refused) {
        link->refused = true;
        if (++link->refusals == MOST_REFUSALS) lost = give_up(link, given_up);
    }
    note_loss(link, now);
    return lost;
}

/* When `note_time` must be called; posted writes alone have no answer to wait for. */
static bool has_deadline(ul_link *link, double *deadline)
{
    if (in_flight(link) == link->unfenced && !is_repeating(link)) return false;
    /* RFC 6298 knows no messages of unlike sizes: the answer to a long one behind short ones is not late yet. */
    double reply = (double)reply_size(link, slot_of(link, link->oldest));
    double wire_time = link->byte_time * (double)link->bytes + link->reply_byte_time * reply;
    *deadline = link->since + link->timeout + wire_time;
    return true;
}

/* Go back where it is time to; once too often gives the request up. Whether the gateway is gone. */
static bool note_time(ul_link *link, double now, ul_request *given_up)
{
    double deadline;
    if (!has_deadline(link, &deadline) || now < deadline) return false;
    bool lost = false;
    link->tries++;
    link->statistics.timeouts++;
    /* Also where something was heard: it may be the beginning of a long answer on a slow line. */
    link->timeout = 2 * link->timeout < LONGEST_TIMEOUT ? 2 * link->timeout : LONGEST_TIMEOUT;
    if (!link->heard) {
        lost = ++link->silent_tries >= FEWEST_SILENT_TRIES && now - link->silent_since >= LONGEST_SILENCE;
    } else {
        link->silent_tries = 0;
        link->silent_since = now;
        if (link->tries > MOST_TRIES) lost = give_up(link, given_up);
    }
    link->heard = false;
    go_back(link, now, true);
    return lost;
}
