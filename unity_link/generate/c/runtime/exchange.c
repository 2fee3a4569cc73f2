/* Exchange: requests go out, answers find their requests. --------------------------------------------------------------
 *
 * Receiving only changes the window and the samples that wait; it never sends. So bytes can be taken in while bytes
 * cannot be got rid of, and neither side waits for the other. All sending is done by `turn`, `start` and those above.
 */

enum { MOST_READS = 16 };
static const char SILENT[] = "the gateway does not answer any more";
static const char LINE_GONE[] = "the connection was lost (its port, or its other side, is gone)";

static void receive_bytes(ul_link *link);
static void take_sample(ul_link *link, text body);

static double now_of(const ul_link *link)
{
    return link->transport.now == NULL ? 0 : link->transport.now(link->transport.context);
}

static bool is_lost(ul_status status)
{
    return status == UL_LOST || status == UL_LOST_EXECUTED || status == UL_LOST_NOT_EXECUTED;
}

/* Leave a sentence for `ul_error`. Without a reason it is that of the status, and of a lost link what ended it. */
static ul_status fail(ul_link *link, ul_status status, const char *what, const char *reason)
{
    const char *between = *what == '\0' ? "" : ": ", *outcome = "";
    if (reason == NULL) reason = ul_status_text(status);
    if (is_lost(status) && link->end != NULL) {
        outcome = strchr(reason, ';');
        reason = link->end;
    }
    snprintf(link->error, sizeof link->error, "%s%s%s%s", what, between, reason, outcome);
    return status;
}

static ul_status fail_at(ul_link *link, ul_status status, const char *what, uint32_t address, const char *reason)
{
    char where[128];
    snprintf(where, sizeof where, "%.100s at 0x%0*lX", what, (int)link->address_digits, (unsigned long)address);
    return fail(link, status, where, reason);
}

static ul_status fail_batch(ul_link *link, const ul_batch *batch)
{
    return fail_at(link, batch->status, batch->what, batch->address, batch->reason);
}

/* Put the end of a request into its batch, if it has one. Nothing of the caller's is touched for it any more. */
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
        batch->what = shape_of(request->command)->name;
    } else if (is_lost(batch->status) && is_lost(status) && status != batch->status) {
        batch->status = UL_LOST;
    }
    if (batch->answered > 0 && batch->status == UL_LOST_NOT_EXECUTED) batch->status = UL_LOST;
}

/* End a request before it has begun. */
static void refuse(ul_batch *batch, ul_status status, const char *what, uint32_t address, const char *reason)
{
    if (batch == NULL || batch->status != UL_OK) return;
    batch->status = status;
    batch->what = what;
    batch->address = address;
    batch->reason = reason;
}

/* The session has ended, and all its requests with it: those from a place in the window on are known not to be executed,
 * unless they were sent more than once. */
static void end_session(ul_link *link, uint32_t never, const char *end)
{
    uint32_t executed = distance(link, link->executed), sent_once = distance(link, link->sent_once);
    if (!link->gone) link->end = end;
    link->gone = true;
    if (never < sent_once) never = sent_once;
    for (uint32_t place = 0; place < in_flight(link); place++) {
        ul_request *request = slot_of(link, link->oldest + place);
        ul_status status = place < executed ? UL_LOST_EXECUTED : place < never ? UL_LOST : UL_LOST_NOT_EXECUTED;
        if (request->waiting) settle(request, status);
        request->waiting = false;
    }
    link->oldest = link->executed = link->sent_once = link->to_repeat = link->next;
    link->unfenced = 0;
    link->bytes = 0;
}

/* The line has ended, of which nothing is known about the requests under way. */
static void lose(ul_link *link, const char *end)
{
    end_session(link, in_flight(link), end);
}

/* End the link. From here on its transport is the caller's again, and not used any more. */
static void shut(ul_link *link)
{
    lose(link, "the link was closed");
    link->open = false;
    link->subscriptions = NULL;
    link->transport.close(link->transport.context);
    link->transport = (ul_transport){.context = NULL};
}

/* Sending */

static void flush(ul_link *link)
{
    size_t sent = 0;
    double stuck_since = now_of(link);
    while (sent < link->send_size && !link->gone) {
        ptrdiff_t taken = link->transport.send(link->transport.context, link->send + sent, link->send_size - sent);
        if (taken < 0) {
            lose(link, LINE_GONE);
        } else if (taken > 0) {
            sent += (size_t)taken;
            stuck_since = now_of(link);
        } else if (now_of(link) - stuck_since >= LONGEST_SILENCE) {
            lose(link, SILENT);
        } else {
            link->transport.wait(link->transport.context, true, LONGEST_TIMEOUT);
            receive_bytes(link);
        }
    }
    link->send_size = 0;
}

static void send_request(ul_link *link, const ul_request *request, uint32_t id)
{
    if (link->send_size + request_size(link, request) > sizeof link->send) flush(link);
    char *start = link->send + link->send_size;
    link->send_size += (size_t)(put_request(link, start, request, id) - start);
}

static void send_fence(ul_link *link)
{
    send_request(link, &FENCE, number_request(link, &FENCE, now_of(link)));
    link->statistics.requests++;
}

/* Send again what is to be sent again now. */
static void repeat(ul_link *link)
{
    unsigned room = repetition_room(link);
    while (is_repeating(link) && !link->gone) {
        uint32_t id = link->to_repeat;
        const ul_request *request = slot_of(link, id);
        if (request->waiting && room == 0) return;
        link->to_repeat = after(link, id);
        if (!request->waiting) continue;
        room--;
        link->statistics.repetitions++;
        send_request(link, request, id);
    }
}

/* Send what is to be sent, wait for something to happen, up to a time, and see to it. */
static void turn(ul_link *link, double until)
{
    double deadline;
    flush(link);
    if (link->gone) return;
    double now = now_of(link);
    if (has_deadline(link, &deadline) && deadline < until) until = deadline;
    if (until > now) link->transport.wait(link->transport.context, false, until - now);
    receive_bytes(link);
    ul_request given_up = {.batch = NULL};
    if (note_time(link, now_of(link), &given_up)) lose(link, SILENT);
    settle(&given_up, UL_UNANSWERED);
    if (is_repeating(link)) repeat(link);
}

/* Say what is wrong with a request, or NULL. */
static const char *fault_of(const ul_link *link, const ul_request *request)
{
    const shape *is = shape_of(request->command);
    uint64_t word = request->word | request->mask;
    if (request->address > ones(has_number(is) ? 8 : link->info.address_bits)) return "the gateway has no such address";
    for (unsigned index = 0; is->words && index < request->count; index++) word |= request->source[index];
    if ((is->word || is->words) && word > ones(link->info.data_bits)) return "the gateway's words have fewer bits";
    return NULL;
}

/* Put a request under way, waiting for room. */
static void start(ul_link *link, ul_batch *batch, ul_request request)
{
    const shape *is = shape_of(request.command);
    size_t size = request_size(link, &request);
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
    while (link->open && !link->gone && !has_room(link, size, request.posted)) {
        if (can_fence(link)) send_fence(link);
        turn(link, now_of(link) + LONGEST_TIMEOUT);
    }
    if (batch != NULL) batch->pending++;
    if (!link->open || link->gone) {
        settle(&request, UL_LOST_NOT_EXECUTED);
        return;
    }
    link->statistics.requests++;
    send_request(link, &request, number_request(link, &request, now_of(link)));
    if (needs_fence(link)) send_fence(link);
}

/* Receiving */

static void note_error(ul_link *link, text code, uint32_t id, double now)
{
    uint64_t number;
    ul_request *request = find(link, id);
    bool sound = take_number(&code, 2, &number) && code.size == 0;
    if (sound && number == UL_NO_SESSION) {
        end_session(link, distance(link, id), "the gateway was reset, which ends the link");
        return;
    }
    if (!sound || request == NULL) {
        link->statistics.stray++;
        return;
    }
    /* An answer that is lost for good, but that nobody wanted, is as good as one. */
    if (number == UL_ANSWER_LOST && request->target == NULL) number = UL_OK;
    settle(request, (ul_status)number);
    link->statistics.responses++;
    note_answer(link, id, now);
}

/* A message with an ID. */
static void take_response(ul_link *link, text body, double now)
{
    size_t letters = body.size > 1 && is_lower_command(body.at[1]) ? 2 : 1;
    char command[3] = {body.at[0], letters == 2 ? body.at[1] : '\0', '\0'};
    text fields = without_first(body, letters);
    uint64_t id;
    if (!take_number(&fields, link->info.id_digits, &id)) {
        link->statistics.stray++;
        return;
    }
    if (strcmp(command, "n") == 0) {
        note_gap(link, (uint32_t)id, now);
        return;
    }
    if (strcmp(command, "x") == 0) {
        note_error(link, fields, (uint32_t)id, now);
        return;
    }
    ul_request *request = find(link, (uint32_t)id);
    if (request != NULL && strcmp(command, request->command) == 0 && take_answer(link, request, fields)) {
        settle(request, UL_OK);
        link->statistics.responses++;
        note_answer(link, (uint32_t)id, now);
    } else {
        link->statistics.stray++;
    }
}

/* An error without an ID is about a frame that was damaged, or that the gateway does not understand. */
static void take_nameless_error(ul_link *link, text code, double now)
{
    uint64_t number;
    if (!take_number(&code, 2, &number)) return;
    if (number == UL_DAMAGED || number == UL_TOO_LONG || number == UL_RECEIVE_OVERFLOW) note_loss(link, now);
    if (number == UL_UNKNOWN_COMMAND || number == UL_MALFORMED) {
        ul_request given_up = {.batch = NULL};
        if (note_refusal(link, now, &given_up)) lose(link, SILENT);
        settle(&given_up, (ul_status)number);
    }
}

/* Whether a line begins as a sample does, which is about no request. */
static bool is_sample(const ul_link *link, text line)
{
    size_t head = link->node < 0 ? 0 : PREFIX_DIGITS;
    return line.size > head && line.at[head] == 'P';
}

static void take_line(ul_link *link, text line)
{
    double now = now_of(link);
    bool sample = is_sample(link, line);
    if (!sample) link->heard = true;
    if (line.size == 0) return;
    if (!take_check(link, &line)) {
        link->statistics.damaged++;
        if (!sample) note_loss(link, now);
        return;
    }
    if (!take_prefix(link, &line) || line.size < 2) return;
    if (is_lower_command(line.at[0])) take_response(link, line, now);
    else if (line.at[0] == 'P') take_sample(link, without_first(line, 1));
    else if (line.at[0] == 'X') take_nameless_error(link, without_first(line, 1), now);
}

/* Give the next whole line of what was received, without its end; false where there is none. */
static bool next_line(ul_link *link, text *line)
{
    const char *at = link->receive + link->receive_start;
    const char *end = memchr(at, CHECKED_END, link->receive_size - link->receive_start);
    if (end == NULL) return false;
    *line = (text){at, (size_t)(end - at)};
    link->receive_start += line->size + 1;
    return true;
}

/* Fill the buffer; false where nothing came. A line longer than the buffer is none. */
static bool fill(ul_link *link)
{
    size_t rest = link->receive_size - link->receive_start;
    memmove(link->receive, link->receive + link->receive_start, rest);
    if (rest == sizeof link->receive) rest = 0;
    link->receive_start = 0;
    link->receive_size = rest;
    size_t room = sizeof link->receive - rest;
    ptrdiff_t come = link->transport.receive(link->transport.context, link->receive + rest, room);
    if (come < 0) lose(link, LINE_GONE);
    if (come <= 0) return false;
    link->receive_size += (size_t)come;
    return true;
}

static void receive_bytes(ul_link *link)
{
    text line;
    /* Not for ever, where samples come as fast as they are taken. */
    for (int reads = 0; reads < MOST_READS && !link->gone && fill(link); reads++) {
        while (next_line(link, &line)) take_line(link, line);
        text rest = {link->receive + link->receive_start, link->receive_size - link->receive_start};
        /* Perhaps the beginning of a long answer on a slow line. */
        if (rest.size > 0 && !is_sample(link, rest)) link->heard = true;
    }
}
