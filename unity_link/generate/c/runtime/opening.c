/* Opening: the configuration of the gateway, and the start of a session (docs/protocol.md, Configuration). ------------
 *
 * `Q` is sent in plain form, because the gateway's CRC is not known, and then in the checked form that follows from the
 * answer. The answer is accepted only if both are equal. `K` then starts the session: the gateway expects the ID in
 * `K`, and stops all groups. Each `K` has another session number, and the CRC of each frame depends on this number, so
 * that no frame of an earlier session is accepted in this one.
 *
 * If the session has the compact form, the line is then tried. If the line does not carry the compact form, another
 * session begins, whose frames are text.
 *
 * An adapter that receives while it sends echoes each question; the echo is skipped.
 */

enum { PROTOCOL_VERSION = 3, LONGEST_ANSWER = 160 };
enum { LONGEST_QUESTION = 32, CONFIGURATION_DIGITS = 64, FEWEST_CHANGED = 2 };

static const char NOT_CARRIED[] =
    "the gateway answers text but no compact frames: the line changes bytes, and compact=0 in the URL keeps text";
static const char ECHO[] = "what is sent comes back as it is: is TX wired to RX, or an echo switched on?";

static const char LINE_ENDS[] =
    "the line changes CR or LF, as a terminal or a terminal server does that is not raw: make it transparent";

typedef struct opening {
    ul_link *link;
    double asked, patience;
    double round_trip;                  /* seconds, of the last answered question */
    size_t heard;
    unsigned questions, answers, drawn;
    unsigned astray, changed;           /* lines that are no answers, and those that would be with another line end */
    uint32_t first;                     /* ID of the session */
    bool believes;                      /* the configuration of the gateway is known */
    bool hears_echo;
    bool is_compact;                    /* the session was requested in compact form */
    bool not_carried;                   /* the line does not carry the compact form */
    bool is_alone, is_loop;             /* only echoes were received so far; and for so long that it is a loop */
    double alone_since;
    char asked_text[LONGEST_QUESTION];  /* the last question as it was sent; without LF if it is checked */
    char answer[LONGEST_ANSWER];
    size_t size;
} opening;

/* Reduce a line to its body; false if the line is no frame of this node, or its CRC depends on a session. */
static bool take_line_body(const opening *opens, bool plain, text *line)
{
    if ((line->size > 0 && line->at[line->size - 1] == PLAIN_END) != plain) return false;
    if (plain) line->size--;
    else if (!take_check(opens->link, line, 0)) return false;
    return take_prefix(opens->link, line);
}

/* Skip the echo of the question; true if there was one. In plain form the answer follows in the same line. */
static bool take_echo(opening *opens, text *line)
{
    size_t size = strlen(opens->asked_text);
    bool is_plain = opens->asked_text[size - 1] == PLAIN_END;
    if (!starts_with(*line, opens->asked_text) || (!is_plain && line->size > size)) return false;
    *line = without_first(*line, size);
    double now = now_of(opens->link);
    if (!opens->is_alone) opens->alone_since = now;
    opens->is_alone = !opens->believes;
    opens->is_loop = opens->is_alone && !opens->link->transport.echoes && now - opens->alone_since > ECHO_PATIENCE;
    opens->hears_echo = true;
    return true;
}

/* Pad the opening of a session with empty frames to the longest datagram, so that it tests whether the network
 * carries such a datagram. */
static char *put_padding(const ul_link *link, char *at)
{
    size_t most = link->largest_datagram - MOST_HEADER;
    if (most > sizeof link->send) most = sizeof link->send;
    if (!(link->info.features & UL_FEATURE_FLOW_CONTROL) && most > link->info.receive_fifo_bytes)
        most = link->info.receive_fifo_bytes;
    while (at < link->send + most) *at++ = CHECKED_END;
    return at;
}

/* Send a question after a line end, which ends an unfinished frame of an earlier program. The line end is LF,
 * because CR would execute the unfinished frame without a CRC. */
static void send_question(opening *opens, const char *question, bool plain, bool padded)
{
    ul_link *link = opens->link;
    char *start = put_text(link->send, "\n"), *at = put_text(put_prefix(link, start), question);
    at = plain ? put_text(at, "\r") : put_check(link, at, start);
    size_t size = (size_t)(at - start) - !plain;
    memcpy(opens->asked_text, start, size);
    opens->asked_text[size] = '\0';
    if (padded) at = put_padding(link, at);
    link->send_size = (size_t)(at - link->send);
    flush(link);
    opens->asked = now_of(link);
    opens->questions++;
}

/* Whether an undamaged line is the answer: it begins with the question, and has `fields` more characters, or any
 * number if `fields` is 0. The answer to an earlier `K` is not the answer, and not damaged. */
static bool is_answer(text line, const char *question, size_t fields)
{
    return starts_with(line, question) && line.size <= LONGEST_ANSWER
        && (fields == 0 ? line.size > strlen(question) : line.size == strlen(question) + fields);
}

/* The part of a line after samples of an earlier session, which have no line end in compact form. */
static text behind_compact(text line)
{
    size_t size = line.size;
    while (size > 0 && line.at[size - 1] != (char)COMPACT_END) size--;
    return without_first(line, size);
}

/* The number of digits of a text from its second character on; 0 if it has other characters. */
static size_t count_digits(text line)
{
    for (size_t place = 1; place < line.size; place++)
        if (digit_value(line.at[place]) < 0) return 0;
    return line.size > 0 ? line.size - 1 : 0;
}

/* Whether a line would be the answer to `Q`, or an error, if it had the other line end. This shows that the line
 * changes CR or LF. */
static bool has_other_end(const opening *opens, text line, bool plain)
{
    bool ends_plain = line.size > 0 && line.at[line.size - 1] == PLAIN_END;
    while (line.size > 0 && line.at[line.size - 1] == PLAIN_END) line.size--;
    if (ends_plain == plain || !take_prefix(opens->link, &line)) return false;
    size_t digits = count_digits(line);
    if (starts_with(line, "Q")) {
        size_t check = digits - CONFIGURATION_DIGITS;
        return digits >= CONFIGURATION_DIGITS && (plain ? check == 0 : check == 2 || check == 4 || check == 8);
    }
    return starts_with(line, "X") && (plain ? digits == 4 || digits == 6 || digits == 10 : digits == 2);
}

/* Whether an answer to `Q` has arrived without LF. */
static bool lacks_line_ends(const ul_link *link)
{
    text rest = unread(link);
    for (; rest.size > CONFIGURATION_DIGITS + 2; rest = without_first(rest, 1)) {
        text answer = {rest.at, CONFIGURATION_DIGITS + 1};
        if (rest.at[0] == 'Q' && count_digits(answer) && rest.at[answer.size] == PLAIN_END) return true;
    }
    return false;
}

/* Search the received lines for the answer; false if there is none. Set `damaged` if a line may be a damaged answer. */
static bool find_answer(opening *opens, const char *question, bool plain, size_t fields, bool *damaged)
{
    text line;
    while (next_line(opens->link, &line)) {
        line = behind_compact(line);
        if (take_echo(opens, &line) && line.size == 0) continue;
        bool is_empty = line.size == 0, is_changed = has_other_end(opens, line, plain);
        bool is_frame = take_line_body(opens, plain, &line);
        if (!is_frame || !is_answer(line, question, fields)) {
            opens->astray += !is_empty;
            opens->changed += is_changed;
            *damaged |= !is_frame || line.size == 0 || line.at[0] != 'K';
            continue;
        }
        memcpy(opens->answer, line.at, line.size);
        opens->size = line.size;
        opens->answers++;
        opens->is_alone = opens->is_loop = false;
        return true;
    }
    return false;
}

/* Shorten the retry time after a damaged answer: a gateway that answered quickly will do so again. On a shared
 * medium the line may be that of another node, so the time stays. Return whether the time was shortened. */
static bool shorten(opening *opens, double now, double *end)
{
    double patience = DAMAGE_PATIENCE * (now - opens->asked);
    if (opens->link->node >= 0) return false;
    opens->patience = patience < SHORTEST_TRY ? SHORTEST_TRY : patience < LONGEST_TRY ? patience : LONGEST_TRY;
    *end = now + DAMAGE_PAUSE;
    return true;
}

/* A pseudo-random number from the clock, the transport's seed, and the number of earlier calls. */
static uint32_t draw(opening *opens, unsigned digits)
{
    double now = now_of(opens->link);
    uint64_t bits = 0;
    memcpy(&bits, &now, sizeof now < sizeof bits ? sizeof now : sizeof bits);
    bits = (bits ^ opens->link->transport.seed) * UINT64_C(0x9E3779B97F4A7C15) + ++opens->drawn;
    /* Only the highest bits of the product depend on all bits of the factors. */
    return (uint32_t)(bits * UINT64_C(0x9E3779B97F4A7C15) >> (64 - 4 * digits));
}

/* Write the question for a session, with another number each time. 0 is no session; with 10 or 1000 (hex) damage to
 * the first letter of a frame might not be detected. */
static void choose_session(opening *opens, char *question)
{
    ul_link *link = opens->link;
    uint32_t before = link->session;
    do link->session = draw(opens, session_digits(link)) & (uint32_t)ones(4 * session_digits(link) - 1);
    while (link->session == 0 || link->session == before || link->session == (session_digits(link) == 2 ? 0x10 : 0x1000));
    opens->is_compact = link->info.features & UL_FEATURE_COMPACT && !opens->hears_echo && !link->transport.echoes
        && !link->transport.text_only && !opens->not_carried;
    uint32_t asked = link->session | (opens->is_compact ? (uint32_t)1 << (4 * session_digits(link) - 1) : 0);
    *put_number(put_number(put_text(question, "K"), link->info.id_digits, opens->first), session_digits(link), asked) = '\0';
}

/* Send a question until an answer arrives, about `tries` times, and store it in `answer`; NULL asks for a session. */
static bool ask(opening *opens, const char *asked, bool plain, double tries)
{
    ul_link *link = opens->link;
    char session[LONGEST_QUESTION];
    const char *question = asked == NULL ? session : asked;
    size_t fields = asked == NULL ? session_digits(link) : 0;
    if (opens->patience > FIRST_TRY) opens->patience = FIRST_TRY;
    while (tries > 0 && now_of(link) < link->open_until && !link->gone && !opens->is_loop) {
        bool damaged = false, shortened = false;
        bool padded = asked == NULL && link->transport.datagrams;
        if (asked == NULL) choose_session(opens, session);
        if (padded) learn_length(link);
        send_question(opens, question, plain, padded);
        double end = opens->asked + opens->patience;
        /* If only echoes have arrived, wait with the next question until it is certain that the line is a loop. */
        double doubt = opens->alone_since + ECHO_PATIENCE + SHORTEST_TRY;
        if (opens->is_alone && opens->asked < doubt && end > doubt) end = doubt;
        if (end > link->open_until) end = link->open_until;
        for (double now; (now = now_of(link)) < end && !link->gone;) {
            if (find_answer(opens, question, plain, fields, &damaged)) {
                opens->round_trip = now - opens->asked;
                return true;
            }
            if (opens->is_loop) return false;
            if (damaged && !shortened) shortened = shorten(opens, now, &end);
            link->transport.wait(link->transport.context, false, end - now);
            if (fill(link)) opens->heard += link->receive_size;
        }
        /* Shorten datagrams only if the answer had enough time to arrive. */
        if (padded && !shortened && opens->patience > 2 * opens->round_trip) shorten_length(link);
        if (!shortened) opens->patience = 2 * opens->patience < LONGEST_TRY ? 2 * opens->patience : LONGEST_TRY;
        tries -= shortened ? DAMAGE_COST : 1;
    }
    return false;
}

/* Read the fields of the answer to `Q`; fields that later versions append are ignored. */
static bool take_info(ul_info *info, text fields)
{
    static const unsigned char DIGITS[] = {2, 2, 2, 2, 2, 8, 2, 4, 2, 10, 8, 4, 4, 4, 8};
    uint64_t values[sizeof DIGITS];
    for (size_t index = 0; index < sizeof DIGITS; index++)
        if (!take_number(&fields, DIGITS[index], &values[index])) return false;
    *info = (ul_info){
        .version = (unsigned)values[0],
        .data_bits = (unsigned)values[1],
        .address_bits = (unsigned)values[2],
        .id_digits = (unsigned)values[3],
        .crc_bits = (unsigned)values[4],
        .crc_polynomial = (uint32_t)values[5],
        .block_words = (unsigned)values[6],
        .groups = (unsigned)values[7],
        .group_words = (unsigned)values[8],
        .base_frequency_millihertz = values[9],
        .clock_hz = (uint32_t)values[10],
        .receive_fifo_bytes = (unsigned)values[11],
        .transmit_fifo_bytes = (unsigned)values[12],
        .features = (unsigned)values[13],
        .build_id = (uint32_t)values[14],
    };
    return true;
}

/* Whether the protocol allows a number in the configuration. If not, store the sentence of the Python host. */
static bool is_within(ul_link *link, const char *name, uint32_t value, uint32_t low, uint32_t high)
{
    if (value >= low && value <= high) return true;
    snprintf(link->error, sizeof link->error, "the gateway reports %s = %lu, expected %lu to %lu", name,
             (unsigned long)value, (unsigned long)low, (unsigned long)high);
    return false;
}

static bool has_base_frequency(ul_link *link)
{
    if (link->info.base_frequency_millihertz >= 1 || !(link->info.features & UL_FEATURE_GROUPS)) return true;
    fail(link, UL_UNSUPPORTED, "",
         "the gateway reports base_frequency_millihertz = 0, expected 1 to 1099511627775 as it has groups");
    return false;
}

static bool has_check(ul_link *link)
{
    unsigned bits = link->info.crc_bits;
    unsigned long polynomial = link->info.crc_polynomial;
    if ((bits == 8 || bits == 16 || bits == 32) && polynomial > 0 && polynomial <= ones(bits)) return true;
    snprintf(link->error, sizeof link->error,
             "the gateway reports a CRC of %u bits with polynomial 0x%lx, expected 8, 16 or 32 bits and a polynomial "
             "that fits",
             bits, polynomial);
    return false;
}

static bool has_even_words(ul_link *link)
{
    unsigned bits = link->info.data_bits;
    if (!(link->info.features & UL_FEATURE_COMPACT) || (bits + 3) / 4 % 2 == 0) return true;
    snprintf(link->error, sizeof link->error,
             "the gateway reports the compact form and data_bits = %u, expected words with an even number of hex digits",
             bits);
    return false;
}

static bool is_possible(ul_link *link)
{
    const ul_info *info = &link->info;
    return is_within(link, "data_bits", info->data_bits, 8, 64)
        && is_within(link, "address_bits", info->address_bits, 8, 32)
        && is_within(link, "id_digits", info->id_digits, 2, 3)
        && is_within(link, "block_words", info->block_words, 1, 255)
        && is_within(link, "groups", info->groups, 0, 256)
        && is_within(link, "clock_hz", info->clock_hz, 1, UINT32_MAX)
        && has_base_frequency(link) && has_check(link) && has_even_words(link);
}

static void use_info(ul_link *link)
{
    const ul_info *info = &link->info;
    link->ring_mask = (uint32_t)ones(4 * info->id_digits);
    link->address_digits = (info->address_bits + 3) / 4;
    link->data_digits = (info->data_bits + 3) / 4;
    prepare_check(link, info->crc_bits, info->crc_polynomial);
    link->block_words = most_in_frame(link, info->block_words);
}

/* Use the configuration in an answer to `Q`; store a sentence if it is not possible. */
static ul_status believe(ul_link *link, text fields)
{
    uint64_t version;
    text rest = fields;
    if (take_number(&rest, 2, &version) && version != PROTOCOL_VERSION) {
        snprintf(link->error, sizeof link->error,
                 "the gateway speaks version %02X of the protocol and this program version %02X: build the gateway "
                 "anew with this version of unity-link, or generate the client with one that speaks %02X",
                 (unsigned)version, (unsigned)PROTOCOL_VERSION, (unsigned)version);
        return UL_UNSUPPORTED;
    }
    if (!take_info(&link->info, fields)) return UL_NO_CONNECTION;
    if (!is_possible(link)) return UL_UNSUPPORTED;
    use_info(link);
    return UL_OK;
}

/* Whether an answer equals the last one. */
static bool is_last_answer(const opening *opens, text answer)
{
    return answer.size == opens->size && memcmp(answer.at, opens->answer, answer.size) == 0;
}

/* Store a sentence about the most likely reason why no session has begun. */
static ul_status fail_to_open(const opening *opens)
{
    ul_link *link = opens->link;
    if (opens->is_alone && !link->transport.echoes) return fail(link, UL_NO_CONNECTION, "", ECHO);
    if (link->gone) return fail(link, UL_NO_CONNECTION, "", "the connection was lost before the gateway answered");
    if (opens->not_carried) return fail(link, UL_NO_CONNECTION, "", NOT_CARRIED);
    if ((opens->changed >= FEWEST_CHANGED && 2 * opens->changed > opens->astray) || lacks_line_ends(link))
        return fail(link, UL_NO_CONNECTION, "", LINE_ENDS);
    if (opens->believes) {
        snprintf(link->error, sizeof link->error,
                 "the gateway answered %u of %u questions: requests or answers are lost or damaged on the way, "
                 "or this computer is too busy%s",
                 opens->answers, opens->questions, path_advice(link));
        return UL_NO_CONNECTION;
    }
    if (opens->heard > 0)
        return fail(link, UL_NO_CONNECTION, "",
                    "no gateway answered, but bytes arrived: check the speed of the port, and that CR and LF arrive unchanged");
    return fail(link, UL_NO_CONNECTION, "", "no gateway answered: check its power, the port and the wiring");
}

/* Read the configuration of the gateway. A plain answer has no CRC: an impossible one is requested again, and
 * accepted only after SURE equal answers. */
static ul_status learn(opening *opens)
{
    ul_link *link = opens->link;
    ul_status status = UL_NO_CONNECTION;
    char kept[LONGEST_ANSWER];
    text plain = {kept, 0};
    for (unsigned alike = 0; ask(opens, "Q", true, FOR_EVER);) {
        alike = is_last_answer(opens, plain) ? alike + 1 : 1;
        plain.size = opens->size;
        memcpy(kept, opens->answer, plain.size);
        status = believe(link, without_first(plain, 1));
        if (status == UL_OK) opens->believes = true;
        if (status == UL_UNSUPPORTED && alike == SURE) break;
        if (status == UL_OK && ask(opens, "Q", false, CHECKED_TRIES) && is_last_answer(opens, plain)) return UL_OK;
    }
    return status == UL_UNSUPPORTED ? status : fail_to_open(opens);
}

/* The trial of the line (docs/protocol.md, The trial of the line): requests that execute nothing. Their IDs produce,
 * in both directions, the bytes that some lines change. The last request restarts a line that another one has
 * stopped. */
static const uint16_t TRIED_2[] = { {{ TRIAL.IDS[2] | join(", ") }} }, TRIED_3[] = { {{ TRIAL.IDS[3] | join(", ") }} };
enum { MOST_TRIED = sizeof TRIED_3 / sizeof *TRIED_3 };
enum { FIRST_2 = {{ TRIAL.FIRST_IDS[2].start }}, FIRSTS_2 = {{ TRIAL.FIRST_IDS[2] | length }} };
enum { FIRST_3 = {{ TRIAL.FIRST_IDS[3].start }}, FIRSTS_3 = {{ TRIAL.FIRST_IDS[3] | length }} };

typedef struct trial {
    uint16_t ids[MOST_TRIED];   /* IDs of the requests that are not answered */
    unsigned left;
    int awaited;                /* answers to the last burst that have not arrived; damaged ones count as arrived */
} trial;

static void put_trial(ul_link *link, trial *tries)
{
    for (unsigned index = 0; index < tries->left; index++) send_request(link, &FENCE, tries->ids[index]);
    tries->awaited = (int)tries->left;
}

/* Try a single request, because the gateway cannot receive more at once. */
static void try_alone(const ul_link *link, trial *tries)
{
    tries->ids[0] = link->info.id_digits == 2 ? {{ TRIAL.ID_ALONE[2] }} : {{ TRIAL.ID_ALONE[3] }};
    tries->left = 1;
}

/* Process an answer: `h` with a count of 0 failed posted writes, or an error that the gateway has stored in an
 * earlier session. */
static void take_tried(const ul_link *link, trial *tries, text line)
{
    uint64_t id, field;
    char letter = first_letter(link, line);
    tries->awaited--;
    if (!take_check(link, &line, seed_of(link, letter, THEIRS)) || !take_prefix(link, &line)) return;
    line = without_first(line, 1);
    if (!take_number(&line, link->info.id_digits, &id)) return;
    if (!take_number(&line, letter == 'h' ? link->info.id_digits : 2, &field) || line.size > 0) return;
    if (letter == 'h' ? field != 0 : letter != 'x' || field < UL_BUS_ERROR || field > UL_OUT_OF_RANGE) return;
    for (unsigned index = 0; index < tries->left; index++)
        if (tries->ids[index] == id)
            memmove(tries->ids + index, tries->ids + index + 1, (--tries->left - index) * sizeof *tries->ids);
}

/* Try the line; true if it carries the compact form. */
static bool carries_compact(opening *opens, double round_trip)
{
    ul_link *link = opens->link;
    trial tries = {.left = link->info.id_digits == 2 ? sizeof TRIED_2 / sizeof *TRIED_2 : MOST_TRIED};
    memcpy(tries.ids, link->info.id_digits == 2 ? TRIED_2 : TRIED_3, tries.left * sizeof *tries.ids);
    if (is_half_duplex(link)) try_alone(link, &tries);
    for (int times = 0; times < TRIALS && !link->gone; times++) {
        put_trial(link, &tries);
        if (!(link->info.features & UL_FEATURE_FLOW_CONTROL) && link->send_size > link->info.receive_fifo_bytes) {
            link->send_size = 0;
            try_alone(link, &tries);
            put_trial(link, &tries);
        }
        flush(link);
        double end = now_of(link) + FIRST_TRY + TRIAL_FACTOR * round_trip;
        if (end > link->open_until) end = link->open_until;
        for (double now; (now = now_of(link)) < end && !link->gone;) {
            for (text line; next_line(link, &line);)
                if (line.size > 0) take_tried(link, &tries, line);
            if (tries.left == 0) return true;
            if (tries.awaited <= 0 && end > now + DAMAGE_PAUSE) end = now + DAMAGE_PAUSE;
            link->transport.wait(link->transport.context, false, end - now);
            fill(link);
        }
    }
    link->compact = link->in_compact = link->in_line = link->is_escaped = false;
    link->receive_start = link->receive_size = link->shown_size = 0;
    return false;
}

/* Start the session with a first ID. The answer has the number of its `K`. */
static ul_status start_session(opening *opens)
{
    ul_link *link = opens->link;
    bool tries_line = link->info.features & UL_FEATURE_COMPACT && !link->transport.text_only && !link->transport.datagrams;
    opens->first = draw(opens, link->info.id_digits);
    if (tries_line)
        opens->first = link->info.id_digits == 2 ? FIRST_2 + opens->first % FIRSTS_2 : FIRST_3 + opens->first % FIRSTS_3;
    if (!ask(opens, NULL, false, FOR_EVER)) return fail_to_open(opens);
    double round_trip = now_of(link) - opens->asked;
    link->compact = opens->is_compact;
    if (link->compact && tries_line && !carries_compact(opens, round_trip)) {
        opens->not_carried = true;
        if (!ask(opens, NULL, false, FOR_EVER)) return fail_to_open(opens);
        round_trip = now_of(link) - opens->asked;
    }
    link->transport.echoes |= opens->hears_echo;
    link->since = now_of(link);
    start_window(link, opens->first, round_trip / (double)(strlen(opens->asked_text) + 1), round_trip);
    return UL_OK;
}

ul_status ul_open(ul_link *link, const ul_transport *transport, int node, double timeout)
{
    /* Do not clear the members before `info`: the transport may use the link's port. */
    memset(&link->info, 0, sizeof *link - offsetof(ul_link, info));
    link->transport = *transport;
    if (!(transport->shortest_timeout > 0)) link->transport.shortest_timeout = SHORTEST_TIMEOUT;
    link->node = node;
    link->largest_datagram = LARGEST_DATAGRAM;
    link->posts = UL_BATCH;
    link->open_until = now_of(link) + timeout;
    opening opens = {.link = link, .patience = FIRST_TRY};
    /* The comparison refuses NaN. With a time limit in the past there is no answer. */
    ul_status status = !(timeout <= MOST_SECONDS) ? fail(link, UL_BAD_ARGUMENT, "timeout", "1e9 seconds at most were expected")
                     : node > 0xFE ? fail(link, UL_BAD_ARGUMENT, "node", "0 to 254 was expected")
                                   : learn(&opens);
    if (status == UL_OK) status = start_session(&opens);
    link->open = status == UL_OK;
    if (!link->open) shut(link);
    return status;
}

const char *ul_error(const ul_link *link)
{
    return link->error;
}

const char *ul_end(const ul_link *link)
{
    return link->end;
}

const char *ul_status_text(ul_status status)
{
    switch (status) {
    case UL_OK: return "no error";
    case UL_DAMAGED: return "the frame was damaged on the way";
    case UL_UNKNOWN_COMMAND: return "the gateway does not know the command";
    case UL_MALFORMED: return "the gateway expects fields of another width";
    case UL_BUS_ERROR: return "the bus refused the access";
    case UL_BUS_TIMEOUT: return "nothing on the bus answered";
    case UL_OUT_OF_RANGE: return "the gateway says that a value is out of its range";
    case UL_TOO_LONG: return "the frame is longer than the gateway takes";
    case UL_RECEIVE_OVERFLOW: return "the gateway lost bytes of the frame";
    case UL_NO_SESSION: return "the gateway was reset";
    case UL_SESSION_UNDER_WAY: return "another session is under way";
    case UL_LOST: return "the link was lost; the request is perhaps executed";
    case UL_LOST_EXECUTED: return "the link was lost; the request is known to be executed";
    case UL_LOST_NOT_EXECUTED: return "the link was lost; the request is known not to be executed";
    case UL_UNANSWERED: return "every try was damaged on the way; the request is perhaps executed";
    case UL_NO_CONNECTION: return "no connection to a gateway";
    case UL_UNSUPPORTED: return "the gateway was built without it";
    case UL_BAD_ARGUMENT: return "not an address or value that it takes";
    case UL_NO_SAMPLE: return "no sample came in time";
    case UL_NOT_COMMITTED: return NOT_COMMITTED;
    }
    return "an error of the gateway that this version does not know";
}

/* Whether the gateway reports that it was built for another map. */
static bool is_of_another_map(const ul_link *link, uint32_t map)
{
    return link->info.features & UL_FEATURE_FINGERPRINT && link->info.build_id != map && !link->any_map;
}

void ul_allow_any_map(ul_link *link)
{
    link->any_map = true;
}

ul_status ul_check_map(ul_link *link, uint32_t map, const char *name)
{
    if (!is_of_another_map(link, map)) return UL_OK;
    snprintf(link->error, sizeof link->error,
             "the gateway was built for the map %08lX, and %.40s describes the map %08lX: generate the client from the "
             "spec that the gateway was built from, or build the gateway anew, or write map=any in the URL",
             (unsigned long)link->info.build_id, name, (unsigned long)map);
    return UL_UNSUPPORTED;
}
