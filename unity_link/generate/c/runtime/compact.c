/* The compact form: two digits in each byte, between delimiters of its own (docs/protocol.md, The compact form). ------
 *
 * The other parts of the runtime see only text. The text of a frame is complete once the frame has ended.
 */

enum { COMPACT_START = {{ COMPACT.START }}, COMPACT_END = {{ COMPACT.END }} };
enum { COMPACT_ESCAPE = {{ COMPACT.ESCAPE }}, COMPACT_STUFFED = {{ COMPACT.STUFFED }} };

/* Commands with a compact form, by number. Commands below FIRST_WITHOUT_ADDRESS have an address. */
static const char COMPACT_COMMANDS[][3] = { {{ COMPACT.COMMANDS | map("tojson") | join(", ") }} };
enum { FIRST_WITHOUT_ADDRESS = 8, COMPACT_COMMAND_COUNT = sizeof COMPACT_COMMANDS / sizeof *COMPACT_COMMANDS };

/* Whether a digit 0 follows the number of a command, to make the number of digits even. */
static bool is_filled(const ul_link *link, unsigned command, unsigned sender)
{
    const char *letters = COMPACT_COMMANDS[command];
    unsigned digits = 1 + link->crc_digits;
    if (letters[0] != 'P') digits += link->info.id_digits;
    if (command < FIRST_WITHOUT_ADDRESS && sender == OURS) digits += link->address_digits;
    if (letters[0] == 'h' && sender == THEIRS) digits += link->info.id_digits;
    return digits % 2;
}

static char *put_compact_byte(char *at, unsigned byte)
{
    if (byte == COMPACT_START || byte == COMPACT_END || byte == COMPACT_ESCAPE || is_line_end((char)byte)) {
        *at++ = (char)COMPACT_ESCAPE;
        byte ^= COMPACT_STUFFED;
    }
    *at++ = (char)byte;
    return at;
}

/* The number of a command; COMPACT_COMMAND_COUNT if it has no compact form. */
static unsigned number_of(const char *command)
{
    unsigned number = 0;
    while (number < COMPACT_COMMAND_COUNT && strcmp(COMPACT_COMMANDS[number], command) != 0) number++;
    return number;
}

/* Write a frame of the host in compact form, or as text if its command has no compact form. The text of the frame
 * may be in the same buffer, COMPACT_ROOM or more bytes after `at`. */
enum { COMPACT_ROOM = 4 };

static char *put_compact(const ul_link *link, char *at, text frame)
{
    char letters[3];
    text rest = take_command(without_first(frame, prefix_size(link)), letters);
    uint64_t byte;
    unsigned command = number_of(letters);
    if (command == COMPACT_COMMAND_COUNT) {
        memmove(at, frame.at, frame.size);
        return at + frame.size;
    }
    *at++ = (char)COMPACT_START;
    if (link->node >= 0) at = put_compact_byte(at, (unsigned)link->node);
    byte = 0;
    if (!is_filled(link, command, OURS)) take_number(&rest, 1, &byte);
    at = put_compact_byte(at, command << 4 | (unsigned)byte);
    while (take_number(&rest, 2, &byte)) at = put_compact_byte(at, (unsigned)byte);
    *at++ = (char)COMPACT_END;
    /* LF, because nodes without the compact form recognise no other end. */
    if (link->node >= 0) *at++ = CHECKED_END;
    return at;
}

/* Write the text of a byte in a frame of the gateway. */
static char *put_expanded(ul_link *link, char *at, unsigned byte)
{
    if (link->compact_place == UL_AT_NODE) {
        link->compact_place = UL_AT_COMMAND;
        return put_number(put_text(at, "Z"), 2, byte);
    }
    if (link->compact_place == UL_AT_DIGITS) return put_number(at, 2, byte);
    link->compact_place = UL_AT_DIGITS;
    at = put_text(at, COMPACT_COMMANDS[byte >> 4]);
    return is_filled(link, byte >> 4, THEIRS) ? at : put_number(at, 1, byte);
}

/* End the text of a truncated frame (docs/protocol.md, Cut frames) with a character that is no digit, so that its
 * CRC is wrong. */
static char *put_cut(char *at)
{
    *at++ = (char)COMPACT_END;
    *at++ = CHECKED_END;
    return at;
}

/* Convert received bytes to text, and return the size of the text. A byte becomes at most MOST_EXPANDED characters.
 * The bytes may be at the end of the same buffer, if the buffer has room for that many characters. */
enum { MOST_EXPANDED = 3 };     /* Z and two digits of a node, or two letters and a digit */

static size_t expand(ul_link *link, char *to, const char *from, size_t size)
{
    char *at = to;
    for (size_t index = 0; index < size; index++) {
        unsigned byte = (unsigned char)from[index];
        bool ends_line = is_line_end(from[index]), follows_end = link->follows_end;
        link->follows_end = link->node >= 0 && byte == COMPACT_END;
        /* On a shared medium this LF belongs to the frame before it. */
        if (follows_end && byte == CHECKED_END) continue;
        if (byte == COMPACT_START) {
            if (link->in_compact || link->in_line) at = put_cut(at);
            link->in_compact = true;
            link->in_line = link->is_escaped = false;
            link->compact_place = link->node < 0 ? UL_AT_COMMAND : UL_AT_NODE;
        } else if (!link->in_compact && byte != COMPACT_END) {
            *at++ = (char)byte;
            link->in_line = !ends_line;
        } else if (ends_line || byte == COMPACT_END) {
            if (link->in_compact && !link->is_escaped && !ends_line) *at++ = CHECKED_END;
            else at = put_cut(at);
            link->in_compact = link->in_line = link->is_escaped = false;
        } else if (byte == COMPACT_ESCAPE && !link->is_escaped) {
            link->is_escaped = true;
            continue;
        } else {
            at = put_expanded(link, at, link->is_escaped ? byte ^ COMPACT_STUFFED : byte);
            link->is_escaped = false;
            continue;
        }
        link->shown_size = (size_t)(at - link->receive);
    }
    return (size_t)(at - to);
}
