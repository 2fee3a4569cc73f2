/* Exchange: sends requests, and matches answers to them. --------------------------------------------------------------
 *
 * Receiving changes only the window and the stored samples; it never sends. Bytes can therefore be received while the
 * transport accepts none, and neither side waits for the other. All bytes are sent by `turn`, `start` and their
 * callers.
 */

enum { MOST_READS = 16 };
enum { UNKNOWN_ERROR = UL_LOST - 1 };   /* replaces codes that no error of a gateway has */
static const uint32_t UNCOUNTED = UINT32_MAX;   /* number of failed posted writes, if the gateway did not count them */
static const char RESET[] = "the gateway was reset, which ends the link";
static const char TAKEN[] =
    "another program has begun a session with the gateway, and this one's is over: let both use it through "
    "`unity-link serve`, or end the other program";
static const char SILENT[] =
    "the gateway does not answer any more: is it powered and connected, or does another program read its answers?";
static const char FLOODED[] =
    "only lines that are no answer arrive: is an echo on, as after `stty sane`, has the speed of the port changed, or "
    "does another program use it?";
static const char COMPACT_HINT[] = " (if the line changes bytes of compact frames, compact=0 in the URL keeps them text)";
static const char MTU_HINT[] = " (if the network loses long packets, mtu={{ PATH.SHORTEST_MTU }} in the URL keeps them short)";
static const char TOO_WIDE[] = "the gateway's words have fewer bits";
static const char LINE_GONE[] = "the connection was lost (its port, or its other side, is gone)";

static bool fill(ul_link *link);
static void receive_bytes(ul_link *link);
static size_t body_size(const ul_link *link, text frame);
static void take_sample(ul_link *link, text body);
static size_t sample_size(const ul_link *link, text frame);
static bool say_why(ul_link *link, const ul_guard *guard, char *why, size_t size);

static double now_of(const ul_link *link)
{
    return link->transport.now == NULL ? 0 : link->transport.now(link->transport.context);
}

static bool is_lost(ul_status status)
{
    return status == UL_LOST || status == UL_LOST_EXECUTED || status == UL_LOST_NOT_EXECUTED;
}

/* Advice for missing answers: the option for shorter datagrams; empty if no shorter datagrams are possible. */
static const char *path_advice(const ul_link *link)
{
    return link->transport.datagrams && link->largest_datagram > {{ PATH.LENGTHS[-1] }} ? MTU_HINT : "";
}

/* Store a sentence for `ul_error`, and return the status. Without a reason the sentence has the text of the status,
 * or the end of a lost link. */
static ul_status fail(ul_link *link, ul_status status, const char *what, const char *reason)
{
    const char *between = *what == '\0' ? "" : ": ", *outcome = "", *hint = "";
    if (reason == NULL) reason = ul_status_text(status);
    if (is_lost(status) && link->end != NULL) {
        outcome = strchr(reason, ';');
        reason = link->end;
    }
    if (status == UL_UNANSWERED || reason == SILENT || reason == FLOODED)
        hint = link->transport.datagrams ? path_advice(link) : link->compact ? COMPACT_HINT : "";
    snprintf(link->error, sizeof link->error, "%s%s%s%s%s", what, between, reason, hint, outcome);
    return status;
}

static ul_status fail_at(ul_link *link, ul_status status, const char *what, uint32_t address, const char *reason)
{
    char where[128];
    snprintf(where, sizeof where, "%.100s at 0x%0*lX", what, (int)link->address_digits, (unsigned long)address);
    return fail(link, status, where, reason);
}

/* Store a sentence about the first error of a batch. It has the path of a signal, and the reason if a lease refuses
 * the write. */
static ul_status fail_batch(ul_link *link, const ul_batch *batch)
{
    const ul_signal *signal = batch->signal;
    char what[128], why[192], reason[256];
    if (signal == NULL) return fail_at(link, batch->status, batch->what, batch->address, batch->reason);
    snprintf(what, sizeof what, "%s of %.80s", batch->what, signal->path);
    if (batch->status != UL_BUS_ERROR || signal->guard == NULL || !say_why(link, signal->guard, why, sizeof why))
        return fail_at(link, batch->status, what, batch->address, batch->reason);
    snprintf(reason, sizeof reason, "%s: %s", ul_status_text(UL_BUS_ERROR), why);
    return fail_at(link, batch->status, what, batch->address, reason);
}

/* Record the end of a request in its batch, if it has one. After that the caller's memory is not accessed for this
 * request. */
static void settle(const ul_request *request, ul_status status)
{
    ul_batch *batch = request->batch;
    if (batch == NULL) return;
    if (batch->pending > 0) batch->pending--;
    if (status == UL_OK) batch->answered++;
    else if (status == UL_LOST) batch->unknown++;
    else if (status == UL_LOST_NOT_EXECUTED) batch->not_executed++;
    else if (status != UL_LOST_EXECUTED) batch->failed++;
    if (status != UL_OK && batch->status == UL_OK) {
        batch->status = status;
        batch->address = request->address;
        batch->signal = request->signal;
        batch->what = shape_of(request->posted ? "ws" : request->command)->name;
    } else if (is_lost(batch->status) && is_lost(status) && status != batch->status) {
        batch->status = UL_LOST;
    }
    if (batch->answered > 0 && batch->status == UL_LOST_NOT_EXECUTED) batch->status = UL_LOST;
}

/* Record in a batch that a request is refused before it is sent. */
static void refuse(ul_batch *batch, ul_status status, const char *what, uint32_t address, const char *reason)
{
    if (batch == NULL || batch->status != UL_OK) return;
    batch->status = status;
    batch->what = what;
    batch->address = address;
    batch->reason = reason;
}

/* End the session and all of its requests; requests from the ID `never` on are known not to be executed. */
static void end_session(ul_link *link, uint32_t never, const char *end)
{
    uint32_t executed = (link->executed - link->held) & link->ring_mask;
    uint32_t unknown = (never - link->held) & link->ring_mask;
    if (!link->gone) link->end = end;
    link->gone = true;
    for (uint32_t place = 0; place < places_held(link); place++) {
        ul_request *request = slot_of(link, link->held + place);
        ul_status status = place < executed ? UL_LOST_EXECUTED : place < unknown ? UL_LOST : UL_LOST_NOT_EXECUTED;
        if (request->waiting || request->untold) settle(request, status);
        request->waiting = request->untold = false;
    }
    link->held = link->oldest = link->executed = link->to_repeat = link->repeat_end = link->next;
    link->unfenced = link->awaited = link->proofs = 0;
    link->bytes = 0;
}

/* End the session because the line is lost; the outcome of requests in flight is unknown. */
static void lose(ul_link *link, const char *end)
{
    end_session(link, link->next, end);
}

/* Close the link. Its transport belongs to the caller again, and is not used any more. */
static void shut(ul_link *link)
{
    lose(link, "the link was closed");
    link->open = false;
    link->subscriptions = NULL;
    link->transport.close(link->transport.context);
    link->transport = (ul_transport){.context = NULL};
}

/* Sending */

{% include "runtime/datagrams.c" %}

/* Append an empty frame to the bytes to send, so that damage to the end of the last frame is detected. */
static void end_output(ul_link *link)
{
    if (link->send_size > 0 && !is_half_duplex(link)) link->send[link->send_size++] = CHECKED_END;
}

/* Send all buffered bytes. While the link is being opened, stop at the time limit for opening. */
static void flush(ul_link *link)
{
    size_t sent = 0;
    double now, stuck_since = now_of(link), until = link->open ? FOR_EVER : link->open_until;
    if (link->loses) end_output(link);
    while (sent < link->send_size && !link->gone) {
        const char *from = link->send + sent;
        size_t left = link->send_size - sent;
        ptrdiff_t taken = link->transport.datagrams ? send_datagram(link, from, left)
                                                    : link->transport.send(link->transport.context, from, left);
        if (taken < 0) {
            lose(link, LINE_GONE);
        } else if (taken > 0) {
            sent += (size_t)taken;
            stuck_since = now_of(link);
        } else if ((now = now_of(link)) >= until) {
            break;
        } else if (now - stuck_since >= LONGEST_SILENCE) {
            lose(link, SILENT);
        } else {
            link->transport.wait(link->transport.context, true, until - now < LONGEST_TIMEOUT ? until - now : LONGEST_TIMEOUT);
            /* While the link is being opened, only store the bytes: `ask` searches them for the answer. */
            if (link->open) receive_bytes(link);
            else fill(link);
        }
    }
    link->send_size = 0;
}

/* Append a request to the bytes to send, and leave room for an empty frame. */
static void send_request(ul_link *link, const ul_request *request, uint32_t id)
{
    size_t room = link->compact ? COMPACT_ROOM : 0;
    if (link->send_size + request_size(link, request) + room >= sizeof link->send) flush(link);
    char *start = link->send + link->send_size, *frame = start + room, *end = put_request(link, frame, request, id);
    if (link->compact) end = put_compact(link, start, (text){frame, (size_t)(end - frame)});
    link->send_size += (size_t)(end - start);
}

static void send_fence(ul_link *link)
{
    send_request(link, &FENCE, number_request(link, &FENCE, now_of(link)));
    link->statistics.requests++;
}

/* Send a session query, which asks for the number of the session. */
static void ask_whose(ul_link *link)
{
    if (link->send_size + question_size(link) >= sizeof link->send) flush(link);
    char *start = link->send + link->send_size;
    char *end = put_check(link, put_text(put_prefix(link, start), "K"), start);
    link->send_size += (size_t)(end - start);
    note_question(link);
}

/* Whether no request is in flight, and the last answer is so old that another program may have begun a session
 * since. */
static bool is_stale(const ul_link *link, double now)
{
    return places_held(link) == 0 && now >= link->since + KEEP_ALIVE;
}

/* The ID of the `h` that asks for the next ID in a proof: the farthest one ahead of the next ID. */
static uint32_t ahead_of_proof(const ul_link *link)
{
    return (link->proof + link->ring_mask / 2) & link->ring_mask;
}

/* Begin to prove that the gateway's session is this one, and not another program's with the same number. `K` asks
 * for the number. An `h` far ahead of the next ID is answered by `n` with the next ID. An `h` with the next ID is an
 * ordinary request: when it is answered, `n` has arrived or was lost. On a half-duplex medium only one frame is sent
 * at a time; this `h` is sent after `n` has arrived. */
static void begin_proof(ul_link *link)
{
    link->proof = link->next;
    link->proofs++;
    link->is_proven = false;
    if (!is_half_duplex(link)) ask_whose(link);
    send_request(link, &FENCE, ahead_of_proof(link));
    if (is_half_duplex(link)) number_request(link, &FENCE, now_of(link));
    else send_fence(link);
}

/* The `h` with the next ID was answered: send requests again, or begin another proof. */
static void end_proof(ul_link *link)
{
    if (link->is_proven) link->proofs = 0;
    else if (link->proofs > MOST_TRIES) lose(link, TAKEN);
    else begin_proof(link);
}

/* Send a session query on a half-duplex medium: alone, before a second retransmission, and not twice in a row.
 * Whether its answer is awaited now. */
static bool ask_alone(ul_link *link, double now)
{
    bool was_asked = link->asked;
    link->asked = was_asked && now < link->answer_by;
    if (was_asked || link->sign != link->sent || link->gone_back < 2) return link->asked;
    ask_whose(link);
    link->asked = true;
    link->answer_by = now + link->timeout;
    return true;
}

/* Retransmit requests, as many as may be sent now. A session query precedes them; its answer also shows which
 * earlier frames the gateway has processed. */
static void repeat(ul_link *link, double now)
{
    uint64_t before = link->statistics.repetitions;
    if (is_half_duplex(link)) {
        if (ask_alone(link, now)) return;
    } else if (link->sign == link->sent) {
        ask_whose(link);
    }
    unsigned room = repetition_room(link);
    while (is_repeating(link) && !link->gone) {
        uint32_t id = link->to_repeat;
        bool is_wanted = find(link, id) != NULL;
        if (is_wanted && room == 0) break;
        link->to_repeat = after(link, id);
        if (!is_wanted) continue;
        room--;
        link->statistics.repetitions++;
        send_request(link, note_repetition(link, id), id);
    }
    if (link->statistics.repetitions > before && !link->loses) end_output(link);
}

/* Whether lines arrive that are no answers, more than the sent frames can cause. */
static bool is_flooded(ul_link *link, double now)
{
    uint32_t sent = link->sent - link->flood_sent;
    if (link->flood_responses == link->statistics.responses)
        return now - link->flood_since >= FLOOD_PATIENCE
            && link->unasked - link->flood_unasked >= FEWEST_OF_A_FLOOD + 2 * (uint64_t)sent;
    link->flood_since = now;
    link->flood_responses = link->statistics.responses;
    link->flood_unasked = link->unasked;
    link->flood_sent = link->sent;
    return false;
}

/* Process timeouts, and retransmit lost requests. */
static void recover(ul_link *link)
{
    ul_request given_up = {.batch = NULL};
    uint64_t before = link->statistics.repetitions;
    double deadline, now = now_of(link);
    bool waits = has_deadline(link, &deadline), is_due = waits && now >= deadline;
    bool flooded = waits && is_flooded(link, now);
    if (note_time(link, now, &given_up)) lose(link, SILENT);
    settle(&given_up, UL_UNANSWERED);
    if (flooded) lose(link, FLOODED);
    if (link->gone) return;
    if (link->proofs > 0 && in_flight(link) == 0) end_proof(link);
    if (is_repeating(link)) repeat(link, now);
    if (link->must_ask && !is_half_duplex(link)) ask_whose(link);
    if (!is_due || !link->waited || link->statistics.repetitions == before) return;
    link->statistics.timeouts++;
    if (link->transport.datagrams) learn_length(link);
    if (link->transport.set_again != NULL)
        link->statistics.set_again += link->transport.set_again(link->transport.context);
}

/* Send the buffered bytes, wait for an event until a time at most, and process it. Retransmissions are only
 * buffered: a caller that does not wait again must call `flush`. */
static void turn(ul_link *link, double until)
{
    double deadline;
    flush(link);
    if (link->gone) return;
    double now = now_of(link);
    if (has_deadline(link, &deadline) && deadline < until) until = deadline;
    if (until > now) link->transport.wait(link->transport.context, false, until - now);
    receive_bytes(link);
    recover(link);
}

/* The fault of a request's arguments; NULL if it has none. */
static const char *fault_of(const ul_link *link, const ul_request *request)
{
    const shape *is = shape_of(request->command);
    uint64_t word = request->word | request->mask;
    if (request->address > ones(has_number(is) ? 8 : link->info.address_bits)) return "the gateway has no such address";
    for (unsigned index = 0; is->words && index < request->count; index++) word |= request->source[index];
    if ((is->word || is->words) && word > ones(link->info.data_bits)) return TOO_WIDE;
    return NULL;
}

/* Send a request, after waiting for room. */
static void start(ul_link *link, ul_batch *batch, ul_request request)
{
    const shape *is = shape_of(request.command);
    request.batch = batch;
    if (link->open) {
        const char *fault = fault_of(link, &request);
        if (fault != NULL) {
            refuse(batch, UL_BAD_ARGUMENT, is->name, request.address, fault);
            return;
        }
        if (is->feature & ~link->info.features) {
            refuse(batch, UL_UNSUPPORTED, is->name, request.address, ul_status_text(UL_UNSUPPORTED));
            return;
        }
    }
    double now = now_of(link);
    if (link->open && !link->gone && is_stale(link, now)) begin_proof(link);
    while (link->open && !link->gone && (link->proofs > 0 || !has_room(link, &request))) {
        if (can_fence(link)) send_fence(link);
        turn(link, now + LONGEST_TIMEOUT);
        now = now_of(link);
    }
    if (batch != NULL) batch->pending++;
    if (!link->open || link->gone) {
        settle(&request, UL_LOST_NOT_EXECUTED);
        return;
    }
    link->statistics.requests++;
    send_request(link, &request, number_request(link, &request, now));
    if (needs_fence(link)) send_fence(link);
}

/* Receiving */

/* Record that the outcome of a request is known; fences after it may have waited for that. */
static void note_told(ul_link *link, uint32_t id, double now)
{
    link->statistics.responses++;
    note_answer(link, id, now);
    if (!slot_of(link, id)->posted) return;
    for (uint32_t place = link->held; place != link->next; place = after(link, place)) {
        ul_request *request = slot_of(link, place);
        if (request->posted && request->waiting) break;
        if (request->posted || !request->untold) continue;
        settle(request, UL_OK);
        request->untold = false;
    }
    release_places(link);
}

static bool is_fence(const ul_request *request)
{
    return shape_of(request->command)->counts && !request->posted;
}

static void note_error(ul_link *link, text code, uint32_t id, double now)
{
    uint64_t number;
    const ul_request *request = find(link, id);
    bool sound = take_number(&code, 2, &number) && code.size == 0;
    if (!sound || request == NULL) {
        link->statistics.stray++;
        return;
    }
    /* Replace codes that are statuses of this side; 08 was an error of version 02 of the protocol. */
    if (number == UL_OK || number == 8 || number >= UL_LOST) number = UNKNOWN_ERROR;
    if (request->posted) link->failed = (link->failed + 1) & link->ring_mask;
    if (!is_fence(request)) settle(request, (ul_status)number);
    /* An error has no count of failed posted writes; a server answers so while it has lost its gateway. Ask for
     * each. */
    else if (note_count(link, id, UNCOUNTED)) settle(request, UL_OK);
    note_told(link, id, now);
}

/* Process `n`, with the ID that the gateway expects. */
static void take_gap(ul_link *link, uint32_t expected, double now)
{
    bool proves = link->proofs > 0;
    link->is_proven = proves && expected == link->proof;
    /* The `h` with this ID is in flight. */
    if (link->is_proven && !is_half_duplex(link)) return;
    if (proves != link->is_proven || !note_gap(link, expected, now)) lose(link, TAKEN);
}

/* Process a message with an ID. */
static void take_response(ul_link *link, text body, double now)
{
    char command[3];
    text fields = take_command(body, command);
    uint64_t id;
    link->heard = true;
    if (!take_number(&fields, link->info.id_digits, &id)) {
        link->statistics.stray++;
        return;
    }
    if (strcmp(command, "n") == 0) {
        take_gap(link, (uint32_t)id, now);
        return;
    }
    if (link->proofs > 0 && id == ahead_of_proof(link)) {
        /* A gateway that expects the next ID would have answered by `n`. */
        lose(link, TAKEN);
        return;
    }
    if (strcmp(command, "x") == 0) {
        note_error(link, fields, (uint32_t)id, now);
        return;
    }
    const ul_request *request = find(link, (uint32_t)id);
    if (request == NULL || strcmp(command, request->command) != 0 || !take_answer(link, request, fields)) {
        link->statistics.stray++;
        return;
    }
    uint64_t failed;
    bool is_told = !is_fence(request) || !take_number(&fields, link->info.id_digits, &failed)
        || note_count(link, (uint32_t)id, (uint32_t)failed);
    if (is_told && !request->posted) settle(request, UL_OK);
    note_told(link, (uint32_t)id, now);
}

/* Process error 0A. Without a session the gateway executes no request with an ID, and answers with the residue of
 * the request's CRC, computed with the initial value 0. If the residue is right for the sent request, the request
 * arrived undamaged, so neither this request nor later ones were executed. */
static void note_no_session(ul_link *link, text fields)
{
    uint64_t id, code, rest;
    if (!take_number(&fields, link->info.id_digits, &id) || !take_number(&fields, 2, &code)) return;
    const ul_request *request = find(link, (uint32_t)id);
    link->heard = true;
    size_t size = request == NULL ? 0 : request_size(link, request) - prefix_size(link) - link->crc_digits - 1;
    if (request != NULL && take_number(&fields, link->crc_digits, &rest)
        && rest == go_on(link, seed_of(link, request->command[0], OURS), NULL, size)) {
        end_session(link, never_executed_from(link, (uint32_t)id), RESET);
    } else {
        link->statistics.stray++;
        go_back(link, now_of(link));
    }
}

/* Process the answer to a session query. An answer to a `K` with fields is that of another program, or late. */
static void take_session(ul_link *link, text fields)
{
    uint64_t session;
    bool is_answer = take_number(&fields, session_digits(link), &session) && fields.size == 0;
    if (!is_answer) return;
    session &= ones(4 * session_digits(link) - 1);
    link->heard = true;
    link->asked = false;
    if (session != link->session) lose(link, session == 0 ? RESET : TAKEN);
    else note_session_told(link, now_of(link));
}

/* Process an error without an ID, which is about a damaged frame, or a frame that the gateway does not support. */
static void take_nameless_error(ul_link *link, text code, double now)
{
    uint64_t number;
    link->heard = true;
    link->unasked++;
    if (!take_number(&code, 2, &number)) return;
    if (number == UL_DAMAGED || number == UL_TOO_LONG || number == UL_RECEIVE_OVERFLOW) go_back(link, now);
    if (number == UL_UNKNOWN_COMMAND || number == UL_MALFORMED) {
        ul_request given_up = {.batch = NULL};
        if (note_refusal(link, now, &given_up)) lose(link, SILENT);
        settle(&given_up, (ul_status)number);
    }
}

/* Count a line that is no answer. */
static void note_stray(ul_link *link)
{
    link->statistics.stray++;
    link->unasked++;
}

static void take_body(ul_link *link, text body, double now)
{
    if (body.size < 2) note_stray(link);
    else if (is_lower_command(body.at[0])) take_response(link, body, now);
    else if (body.at[0] == 'P') take_sample(link, without_first(body, 1));
    else if (body.at[0] == 'X') take_nameless_error(link, without_first(body, 1), now);
    else if (body.at[0] == 'K') take_session(link, without_first(body, 1));
}

/* Frames. The beginning of a frame determines its length. If another byte arrives in the place of its LF, the frame
 * is known to be damaged at once, and the next frame begins after that byte. */

/* Whether a frame begins like error 0A, which has one field more than other errors. */
static bool is_no_session(const ul_link *link, text body)
{
    size_t head = 1 + link->info.id_digits;
    return body.size >= head + 2 && body.at[0] == 'x' && body.at[head] == '0' && body.at[head + 1] == 'A';
}

/* The number of characters in the body of a frame, from its beginning; 0 if unknown. */
static size_t body_size(const ul_link *link, text frame)
{
    char command[3];
    uint64_t id;
    if (frame.at[0] == 'P') return sample_size(link, frame);
    text fields = take_command(frame, command);
    size_t head = strlen(command) + link->info.id_digits;
    /* A sample with a damaged first letter may begin in the same way. On a half-duplex medium wait for the end. */
    if (strcmp(command, "X") == 0) return is_half_duplex(link) ? 0 : 3;
    if (strcmp(command, "K") == 0) return 1 + session_digits(link);
    if (strcmp(command, "n") == 0) return head;
    if (strcmp(command, "x") == 0) return head + 2 + (is_no_session(link, frame) ? link->crc_digits : 0);
    const shape *is = shape_of(command);
    if (is == NULL || strcmp(command, "ws") == 0) return 0;
    if (!is->reads_words) return head + fields_size(link, is, 0);
    if (!take_number(&fields, link->info.id_digits, &id)) return 0;
    const ul_request *request = find(link, (uint32_t)id);
    if (request == NULL || strcmp(command, request->command) != 0) return 0;
    return head + fields_size(link, is, request->count);
}

/* The number of characters of a frame in addition to its body, with the LF. */
static size_t frame_overhead(const ul_link *link)
{
    return prefix_size(link) + link->crc_digits + 1;
}

/* The number of characters of a frame with its LF, from its beginning; 0 if unknown, or if the frame may be an echo,
 * which begins like the answer. */
static size_t frame_size(const ul_link *link, text frame)
{
    if (link->transport.echoes) return 0;
    size_t body = take_prefix(link, &frame) && frame.size > 0 ? body_size(link, frame) : 0;
    return body == 0 ? 0 : body + frame_overhead(link);
}

/* Whether a frame begins like a sample, which belongs to no request. */
static bool is_sample(const ul_link *link, text frame)
{
    return take_prefix(link, &frame) && frame.size > 0 && frame.at[0] == 'P';
}

/* Process a damaged frame at the beginning of the received text; return the number of characters to remove. */
static size_t cut(ul_link *link, text frame, size_t size)
{
    /* A frame as short as an error without ID is a damaged error: inverting one bit turns an X into a P. */
    size_t error_size = frame_overhead(link) + 3;
    bool sample = is_sample(link, frame) && frame.size >= error_size;
    size_t after_cut = size == 0 || size > frame.size + 1 ? frame.size + 1 : size;
    link->statistics.damaged++;
    link->unasked++;
    if (!sample) {
        link->heard = true;
        /* On a half-duplex medium more of the frame may follow; its end is determined by a timeout. */
        if (is_half_duplex(link)) return after_cut;
        if (frame.size + 1 == error_size) go_back(link, now_of(link));
        else note_damaged_answer(link, now_of(link));
    }
    return after_cut;
}

/* Whether a line is the echo of a sent frame, from an adapter that receives while it sends. The CRC depends on the
 * direction, and the length is that of the request. The last requests are still in their slots. */
static bool is_echo(const ul_link *link, text line)
{
    char command[3];
    uint64_t id;
    size_t size = line.size + 1;
    if (size == question_size(link)) return take_check(link, &line, 0) && first_letter(link, line) == 'K';
    if (!take_check(link, &line, seed_of(link, first_letter(link, line), OURS)) || !take_prefix(link, &line)) return false;
    if (line.size < 2 || !is_lower_command(line.at[0])) return false;
    text fields = take_command(line, command);
    if (!take_number(&fields, link->info.id_digits, &id)) return false;
    if (link->proofs > 0 && id == ahead_of_proof(link)) return strcmp(command, FENCE.command) == 0;
    const ul_request *request = &link->slots[id % UL_WINDOW];
    bool is_kept = ((link->next - 1 - (uint32_t)id) & link->ring_mask) < UL_WINDOW;
    return is_kept && strcmp(command, request->command) == 0 && size == request_size(link, request);
}

/* Process a plain frame, which is no answer; an error may be about a request in which a byte became CR. Return the
 * number of characters to remove. */
static size_t take_plain(ul_link *link, text line)
{
    text body = {line.at, line.size - 1};
    char letter = first_letter(link, body);
    if (letter != 'X' && letter != 'x') {
        if (letter == 'P' || is_lower_command(letter)) return cut(link, line, 0);
        note_stray(link);
    } else if (take_prefix(link, &body) && body.size == body_size(link, body)) {
        link->unasked++;
        link->heard = true;
        go_back(link, now_of(link));
    }
    return line.size + 1;
}

/* Process the text before an LF; return the number of characters to remove. */
static size_t take_line(ul_link *link, text line)
{
    text body = line, unbound = line;
    if (line.at[line.size - 1] == PLAIN_END) return take_plain(link, line);
    char letter = first_letter(link, line);
    if (take_check(link, &body, seed_of(link, letter, THEIRS))) {
        if (take_prefix(link, &body)) take_body(link, body, now_of(link));
        else note_stray(link);
    } else if (take_check(link, &unbound, 0) && take_prefix(link, &unbound) && is_no_session(link, unbound)) {
        note_no_session(link, without_first(unbound, 1));
    } else if (is_of_another_node(link, line)) {
        note_stray(link);
    } else if (!is_echo(link, line)) {
        return cut(link, line, frame_size(link, line));
    }
    return line.size + 1;
}

/* Process a frame that has another byte in the place of its LF; return the number of characters to remove, or 0 if
 * the frame is not complete. */
static size_t take_endless(ul_link *link, text rest)
{
    /* Wait for the end of a sample, because no request waits for it. */
    size_t size = is_sample(link, rest) ? 0 : frame_size(link, rest);
    return size == 0 || rest.size < size ? 0 : cut(link, rest, size);
}

static text unread(const ul_link *link)
{
    return (text){link->receive + link->receive_start, link->shown_size - link->receive_start};
}

/* Remove the next complete line from the received text, and store it without its end; false if there is none. */
static bool next_line(ul_link *link, text *line)
{
    text rest = unread(link);
    const char *end = memchr(rest.at, CHECKED_END, rest.size);
    if (end == NULL) return false;
    *line = (text){rest.at, (size_t)(end - rest.at)};
    link->receive_start += line->size + 1;
    return true;
}

/* Process the next frame of the received text; false if there is no complete frame. */
static bool take_frame(ul_link *link)
{
    text rest = unread(link);
    const char *end = memchr(rest.at, CHECKED_END, rest.size);
    size_t taken;
    if (end == NULL) {
        taken = take_endless(link, rest);
    } else if (end == rest.at) {
        /* An empty frame: a server reports that a repeated request is still pending; or it is the echo of sent
         * bytes. */
        link->heard |= !link->transport.echoes;
        link->unasked++;
        taken = 1;
    } else {
        taken = take_line(link, (text){rest.at, (size_t)(end - rest.at)});
    }
    link->receive_start += taken;
    return taken > 0;
}

/* Receive bytes into the buffer; false if none arrived. A line that is longer than the buffer is dropped. */
static bool fill(ul_link *link)
{
    size_t rest = link->receive_size - link->receive_start;
    memmove(link->receive, link->receive + link->receive_start, rest);
    link->shown_size -= link->receive_start;
    size_t room = (sizeof link->receive - rest) / (link->compact ? MOST_EXPANDED : 1);
    if (room == 0) {
        rest = link->shown_size = 0;
        link->in_compact = false;
        link->unasked += FEWEST_OF_A_FLOOD;
        room = sizeof link->receive / (link->compact ? MOST_EXPANDED : 1);
    }
    link->receive_start = 0;
    link->receive_size = rest;
    char *to = link->receive + rest, *at = link->compact ? link->receive + sizeof link->receive - room : to;
    ptrdiff_t come = link->transport.receive(link->transport.context, at, room);
    if (come < 0) lose(link, LINE_GONE);
    if (come <= 0) return false;
    size_t size = link->transport.datagrams ? take_datagram(link, at, (size_t)come) : (size_t)come;
    if (link->compact) {
        link->receive_size += expand(link, to, at, size);
    } else {
        link->receive_size += size;
        link->shown_size = link->receive_size;
    }
    return true;
}

static void receive_bytes(ul_link *link)
{
    /* Limit the number of reads: samples may arrive as fast as they are processed. */
    for (int reads = 0; reads < MOST_READS && !link->gone && fill(link); reads++) {
        while (!link->gone && take_frame(link)) continue;
        text rest = {link->receive + link->receive_start, link->receive_size - link->receive_start};
        /* This may be the beginning of a long answer on a slow line. */
        if (rest.size > 0 && !is_sample(link, rest) && !link->transport.echoes) link->heard = true;
    }
}
