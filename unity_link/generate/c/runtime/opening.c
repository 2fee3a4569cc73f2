/* Opening: what the gateway is, and the start of a session (docs/protocol.md, Configuration). -------------------------
 *
 * `Q` is asked in plain form, because nothing is known yet, and again in the checked form that follows from the answer;
 * only if both agree is the answer believed. `K` then starts the session: the gateway expects ID 0, publishes nothing.
 */

enum { LONGEST_ANSWER = 160, CHECKED_TRIES = 4, LONGEST_REST = 48 };    /* of a frame, beside its words */
static const double FIRST_PATIENCE = 0.1, LONGEST_PATIENCE = 1.0;

typedef struct opening {
    ul_link *link;
    double until;
    size_t heard;
    char answer[LONGEST_ANSWER];
    size_t size;
} opening;

static bool is_answer(const opening *opens, text line, bool plain, const char *beginning, text *answer)
{
    *answer = line;
    if ((line.size > 0 && line.at[line.size - 1] == PLAIN_END) != plain) return false;
    if (plain) answer->size--;
    else if (!take_check(opens->link, answer)) return false;
    return take_prefix(opens->link, answer) && starts_with(*answer, beginning) && answer->size <= LONGEST_ANSWER;
}

/* Ask until an answer comes, at most so many times; it is left in `answer`. */
static bool ask(opening *opens, const char *question, bool plain, unsigned tries)
{
    ul_link *link = opens->link;
    double patience = FIRST_PATIENCE;
    for (; tries > 0 && now_of(link) < opens->until && !link->gone; tries--) {
        /* A line end first, for what an earlier program left unfinished; LF, for CR would execute it unchecked. */
        char *start = put_text(link->send, "\n"), *at = put_text(put_prefix(link, start), question);
        at = plain ? put_text(at, "\r") : put_check(link, at, start);
        link->send_size = (size_t)(at - link->send);
        flush(link);
        double end = now_of(link) + patience;
        for (double now; (now = now_of(link)) < end && !link->gone;) {
            text line, answer;
            while (next_line(link, &line)) {
                if (!is_answer(opens, line, plain, question, &answer)) continue;
                memcpy(opens->answer, answer.at, answer.size);
                opens->size = answer.size;
                return true;
            }
            link->transport.wait(link->transport.context, false, end - now);
            if (fill(link)) opens->heard += link->receive_size;
        }
        patience = 2 * patience < LONGEST_PATIENCE ? 2 * patience : LONGEST_PATIENCE;
    }
    return false;
}

/* Read the fields of the answer to `Q`; what a later version appends is ignored. */
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

static bool is_possible(const ul_info *info)
{
    bool good_check = info->crc_bits == 8 || info->crc_bits == 16 || info->crc_bits == 32;
    return good_check && info->crc_polynomial > 0 && info->crc_polynomial <= ones(info->crc_bits)
        && info->version == 1 && info->data_bits >= 8 && info->data_bits <= 64
        && info->address_bits >= 8 && info->address_bits <= 32
        && (info->id_digits == 2 || info->id_digits == 3) && info->block_words >= 1 && info->clock_hz >= 1;
}

/* How many words, of so many that the gateway takes, have room in a frame here. */
static unsigned most_in_frame(const ul_link *link, unsigned words)
{
    unsigned digits = link->data_digits > link->address_digits ? link->data_digits : link->address_digits;
    unsigned room = (UL_LONGEST_FRAME - LONGEST_REST) / digits;
    return words < room ? words : room;
}

static void use_info(ul_link *link)
{
    const ul_info *info = &link->info;
    link->address_digits = (info->address_bits + 3) / 4;
    link->data_digits = (info->data_bits + 3) / 4;
    prepare_check(link, info->crc_bits, info->crc_polynomial);
    link->block_words = most_in_frame(link, info->block_words);
}

/* Learn what the gateway is. A plain answer has no check: one that makes no sense is asked for again. */
static ul_status learn(opening *opens)
{
    ul_link *link = opens->link;
    bool answered = false;
    while (now_of(link) < opens->until && !link->gone) {
        if (!ask(opens, "Q", true, UINT32_MAX)) break;
        char plain[LONGEST_ANSWER];
        size_t size = opens->size;
        memcpy(plain, opens->answer, size);
        answered = take_info(&link->info, without_first((text){plain, size}, 1));
        if (!answered || !is_possible(&link->info)) continue;
        use_info(link);
        if (ask(opens, "Q", false, CHECKED_TRIES) && size == opens->size && !memcmp(plain, opens->answer, size))
            return UL_OK;
    }
    if (answered && link->info.version != 1)
        return fail(link, UL_UNSUPPORTED, "", "the gateway speaks another version of the protocol: 01 was expected");
    if (answered) return fail(link, UL_UNSUPPORTED, "", "the gateway reports widths that the protocol does not allow");
    if (opens->heard > 0)
        return fail(link, UL_NO_CONNECTION, "", "bytes arrived, but no answer: check the speed of the port");
    return fail(link, UL_NO_CONNECTION, "", "no gateway answered: check its power, the port and the wiring");
}

ul_status ul_open(ul_link *link, const ul_transport *transport, int node, double timeout)
{
    memset(link, 0, sizeof *link);
    link->transport = *transport;
    if (!(transport->shortest_timeout > 0)) link->transport.shortest_timeout = SHORTEST_TIMEOUT;
    link->node = node;
    link->posts = UL_BATCH;
    opening opens = {.link = link, .until = now_of(link) + timeout};
    ul_status status =
        node > 0xFE ? fail(link, UL_BAD_ARGUMENT, "node", "0 to 254 was expected") : learn(&opens);
    if (status == UL_OK) {
        const char *session = link->info.id_digits == 2 ? "K00" : "K000";
        double asked = opens.until;
        bool started = false;
        while (!started && !link->gone && (asked = now_of(link)) < opens.until)
            started = ask(&opens, session, false, 1);
        double round_trip = now_of(link) - asked;
        if (started) start_window(link, round_trip / (double)(strlen(session) + link->crc_digits + 1), round_trip);
        else status = fail(link, UL_NO_CONNECTION, "", "the gateway does not answer any more");
    }
    link->open = status == UL_OK;
    if (!link->open) shut(link);
    return status;
}

const char *ul_error(const ul_link *link)
{
    return link->error;
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
    case UL_ANSWER_LOST: return "the request was executed once, but its answer was lost";
    case UL_RECEIVE_OVERFLOW: return "the gateway lost bytes of the frame";
    case UL_LOST: return "the link was lost; the request is perhaps executed";
    case UL_LOST_EXECUTED: return "the link was lost; the request is known to be executed";
    case UL_LOST_NOT_EXECUTED: return "the link was lost; the request is known not to be executed";
    case UL_UNANSWERED: return "every try was damaged on the way; the request is perhaps executed";
    case UL_NO_CONNECTION: return "no connection to a gateway";
    case UL_UNSUPPORTED: return "the gateway was built without it";
    case UL_BAD_ARGUMENT: return "not an address or value that it takes";
    case UL_NO_SAMPLE: return "no sample came in time";
    }
    return "an error of the gateway that this version does not know";
}
