/* Wire: digits, the CRC, the frame of a request, the fields of an answer (docs/protocol.md, Frames). --------------- */

enum { PLAIN_END = '\r', CHECKED_END = '\n', PREFIX_DIGITS = 3 };
enum { OURS, THEIRS };      /* sender of a frame, host or gateway: part of the CRC's initial value */

typedef struct text {
    const char *at;
    size_t size;
} text;

static uint64_t ones(unsigned bits)
{
    return bits >= 64 ? UINT64_MAX : ((uint64_t)1 << bits) - 1;
}

static int digit_value(char digit)
{
    if (digit >= '0' && digit <= '9') return digit - '0';
    if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
    return -1;
}

static bool is_line_end(char character)
{
    return character == CHECKED_END || character == PLAIN_END;
}

static bool is_lower_command(char letter)
{
    return letter >= 'g' && letter <= 'z';
}

/* Remove a number of `digits` digits from the front; false if there are fewer digits. */
static bool take_number(text *from, unsigned digits, uint64_t *number)
{
    if (from->size < digits) return false;
    *number = 0;
    for (unsigned index = 0; index < digits; index++) {
        int value = digit_value(from->at[index]);
        if (value < 0) return false;
        *number = *number << 4 | (unsigned)value;
    }
    from->at += digits;
    from->size -= digits;
    return true;
}

static bool starts_with(text line, const char *beginning)
{
    size_t size = strlen(beginning);
    return line.size >= size && memcmp(line.at, beginning, size) == 0;
}

static text without_first(text line, size_t size)
{
    return (text){line.at + size, line.size - size};
}

/* Copy the command of one or two letters at the beginning of a message; return the rest of the message. */
static text take_command(text body, char command[3])
{
    size_t letters = body.size > 1 && is_lower_command(body.at[1]) ? 2 : 1;
    memcpy(command, body.at, letters);
    command[letters] = '\0';
    return without_first(body, letters);
}

/* Prepare the table of the CRC: 8, 16 or 32 bits, not reflected, initial value 0, no final xor. */
static void prepare_check(ul_link *link, unsigned bits, uint32_t polynomial)
{
    uint32_t top = (uint32_t)1 << (bits - 1), mask = (uint32_t)ones(bits);
    for (uint32_t byte = 0; byte < 256; byte++) {
        uint32_t rest = byte << (bits - 8);
        for (int bit = 0; bit < 8; bit++) rest = rest & top ? rest << 1 ^ polynomial : rest << 1;
        link->crc_table[byte] = rest & mask;
    }
    link->crc_digits = bits / 4;
}

/* Continue a CRC over `size` characters; NULL for zeros. */
static uint32_t go_on(const ul_link *link, uint32_t rest, const char *at, size_t size)
{
    unsigned bits = 4 * link->crc_digits;
    uint32_t mask = (uint32_t)ones(bits);
    for (size_t index = 0; index < size; index++) {
        uint32_t byte = (rest >> (bits - 8) ^ (at == NULL ? 0 : (unsigned char)at[index])) & 0xFF;
        rest = ((bits == 8 ? 0 : rest << 8) ^ link->crc_table[byte]) & mask;
    }
    return rest;
}

static size_t prefix_size(const ul_link *link)
{
    return link->node < 0 ? 0 : PREFIX_DIGITS;
}

/* The initial value of the CRC after the prefix, from the session and the sender; 0 for a frame without ID. `letter`
 * is the first letter after the prefix. */
static uint32_t seed_of(const ul_link *link, char letter, unsigned sender)
{
    bool belongs = is_lower_command(letter) || letter == 'P';
    return belongs && link->session != 0 ? 2 * link->session + sender : 0;
}

/* The CRC of a frame, with a seed that is applied after the prefix. */
static uint32_t check_of(const ul_link *link, text body, uint32_t seed)
{
    size_t prefix = prefix_size(link) < body.size ? prefix_size(link) : body.size;
    uint32_t rest = go_on(link, 0, body.at, prefix) ^ seed;
    return go_on(link, rest, body.at + prefix, body.size - prefix);
}

/* Remove the CRC from the end of a line; false if it is wrong, or the gateway's CRC is not known yet. */
static bool take_check(const ul_link *link, text *line, uint32_t seed)
{
    if (link->crc_digits == 0 || line->size < link->crc_digits) return false;
    text digits = {line->at + line->size - link->crc_digits, link->crc_digits};
    text body = {line->at, line->size - link->crc_digits};
    uint64_t check;
    if (!take_number(&digits, link->crc_digits, &check) || check != check_of(link, body, seed)) return false;
    *line = body;
    return true;
}

/* The first letter of a frame after the prefix; NUL if there is none. */
static char first_letter(const ul_link *link, text line)
{
    return line.size > prefix_size(link) ? line.at[prefix_size(link)] : '\0';
}

/* Remove the prefix of an addressed frame; false if the line has no prefix or that of another node. */
static bool take_prefix(const ul_link *link, text *line)
{
    if (link->node < 0) return true;
    uint64_t node;
    if (line->size < PREFIX_DIGITS || line->at[0] != 'Z') return false;
    *line = without_first(*line, 1);
    return take_number(line, 2, &node) && node == (unsigned)link->node;
}

/* Whether a frame begins with the prefix of another node, whose session is not known here. */
static bool is_of_another_node(const ul_link *link, text line)
{
    uint64_t node;
    text digits = {line.at + 1, line.size - 1};
    return link->node >= 0 && line.size > 0 && line.at[0] == 'Z' && take_number(&digits, 2, &node)
        && node != (unsigned)link->node;
}

/* The functions below write into a buffer whose room the caller has checked, and return the end of the text. */
static char *put_number(char *at, unsigned digits, uint64_t number)
{
    for (unsigned index = digits; index-- > 0; number >>= 4) at[index] = "0123456789ABCDEF"[number & 15];
    return at + digits;
}

static char *put_text(char *at, const char *characters)
{
    size_t size = strlen(characters);
    memcpy(at, characters, size);
    return at + size;
}

static char *put_prefix(const ul_link *link, char *at)
{
    return link->node < 0 ? at : put_number(put_text(at, "Z"), 2, (unsigned)link->node);
}

static char *put_check(const ul_link *link, char *at, const char *start)
{
    text body = {start, (size_t)(at - start)};
    at = put_number(at, link->crc_digits, check_of(link, body, seed_of(link, first_letter(link, body), OURS)));
    *at++ = CHECKED_END;
    return at;
}

/* The fields of a command after its ID, and of its answer. */
typedef struct shape {
    char command[3];
    bool address, count, mask, word, words, group;
    bool reads_word, reads_words, counts;
    bool is_destructive;        /* the gateway keeps the words of the answer, for repetitions */
    unsigned feature;
    const char *name;
} shape;

static const shape SHAPES[] = {
    {.command = "r", .address = true, .reads_word = true, .name = "read"},
    {.command = "rm", .address = true, .count = true, .reads_words = true, .name = "block read"},
    {.command = "rq", .address = true, .count = true, .reads_words = true, .is_destructive = true,
     .feature = UL_FEATURE_QUEUE_COMMANDS, .name = "queue read"},
    {.command = "w", .address = true, .word = true, .name = "write"},
    {.command = "wm", .address = true, .words = true, .name = "block write"},
    {.command = "wq", .address = true, .words = true, .feature = UL_FEATURE_QUEUE_COMMANDS, .name = "queue write"},
    {.command = "wk", .address = true, .mask = true, .word = true, .reads_word = true,
     .is_destructive = true, .feature = UL_FEATURE_MASKED_WRITE, .name = "masked write"},
    {.command = "ws", .address = true, .word = true, .name = "posted write"},
    {.command = "h", .counts = true, .name = "fence"},
    {.command = "gs", .group = true, .feature = UL_FEATURE_GROUPS, .name = "setting up of group"},
    {.command = "gn", .feature = UL_FEATURE_GROUPS, .name = "start of group"},
    {.command = "gx", .feature = UL_FEATURE_GROUPS, .name = "stop of group"},
    {.command = "gp", .feature = UL_FEATURE_GROUPS, .name = "publishing of group"},
    {.command = "i", .feature = UL_FEATURE_SEND_IMMEDIATE, .name = "choice of send-immediate"},
};

static const shape *shape_of(const char *command)
{
    for (size_t index = 0; index < sizeof SHAPES / sizeof *SHAPES; index++)
        if (strcmp(SHAPES[index].command, command) == 0) return &SHAPES[index];
    return NULL;
}

/* The number of digits of a session's number. */
static unsigned session_digits(const ul_link *link)
{
    return link->crc_digits == 2 ? 2 : 4;
}

/* The number of characters of a session query, with its line end. */
static size_t question_size(const ul_link *link)
{
    return prefix_size(link) + 1 + link->crc_digits + 1;
}

/* Whether a request has no answer except an error. */
static bool has_no_answer(const ul_request *request)
{
    return strcmp(request->command, "ws") == 0;
}

/* Whether a command has a number of two digits, which is in `address`: commands about groups, and `i`. */
static bool has_number(const shape *is)
{
    return strchr("gi", is->command[0]) != NULL;
}

/* The number of characters of an answer's fields, after its ID. */
static size_t fields_size(const ul_link *link, const shape *is, unsigned count)
{
    size_t words = is->reads_word ? 1 : is->reads_words ? count : 0;
    return words * link->data_digits + (is->counts ? link->info.id_digits : 0);
}

/* The numbers of characters of a request and of its answer, with their line ends. */
static size_t request_size(const ul_link *link, const ul_request *request)
{
    const shape *is = shape_of(request->command);
    size_t size = prefix_size(link) + strlen(request->command) + link->info.id_digits;
    if (is->address) size += link->address_digits;
    if (has_number(is)) size += 2;
    if (is->count) size += 2;
    if (is->mask) size += link->data_digits;
    if (is->word) size += link->data_digits;
    if (is->words) size += (size_t)request->count * link->data_digits;
    if (is->group) size += 8 + (size_t)request->count * link->address_digits;
    return size + link->crc_digits + 1;
}

static size_t reply_size(const ul_link *link, const ul_request *request)
{
    const shape *is = shape_of(request->command);
    if (has_no_answer(request)) return 0;
    return prefix_size(link) + strlen(request->command) + link->info.id_digits
        + fields_size(link, is, request->count) + link->crc_digits + 1;
}

/* Write the frame of a request with its ID. */
static char *put_request(const ul_link *link, char *at, const ul_request *request, uint32_t id)
{
    const char *start = at;
    const shape *is = shape_of(request->command);
    at = put_number(put_text(put_prefix(link, at), request->command), link->info.id_digits, id);
    if (is->address) at = put_number(at, link->address_digits, request->address);
    if (has_number(is)) at = put_number(at, 2, request->address);
    if (is->count) at = put_number(at, 2, request->count);
    if (is->mask) at = put_number(at, link->data_digits, request->mask);
    if (is->word) at = put_number(at, link->data_digits, request->word);
    if (is->words)
        for (unsigned index = 0; index < request->count; index++)
            at = put_number(at, link->data_digits, request->source[index]);
    if (is->group) {
        at = put_number(put_number(at, 2, request->word), 4, request->mask);    /* flags and divisor */
        at = put_number(at, 2, request->count);
        for (unsigned index = 0; index < request->count; index++)
            at = put_number(at, link->address_digits, request->addresses[index]);
    }
    return put_check(link, at, start);
}

/* Store the words of an answer, which follow its ID; false if the fields do not fit the request. */
static bool take_answer(const ul_link *link, const ul_request *request, text fields)
{
    const shape *is = shape_of(request->command);
    size_t words = is->reads_word ? 1 : is->reads_words ? request->count : 0;
    if (fields.size != fields_size(link, is, request->count)) return false;
    text all = fields;
    uint64_t word;
    for (size_t index = 0; index < words; index++)
        if (!take_number(&all, link->data_digits, &word)) return false;
    for (size_t index = 0; index < words && request->target != NULL; index++)
        take_number(&fields, link->data_digits, &request->target[index]);
    return true;
}
