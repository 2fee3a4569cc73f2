/* Datagrams: headers that identify late, duplicate and foreign datagrams (docs/protocol.md, Datagrams). ---------------
 *
 * The transport delivers whole datagrams or loses them. Each datagram has a header, followed by complete frames.
 * Received datagrams that are not newer than all before are dropped. The result is a line that keeps the order and may
 * lose frames.
 */

/* Longest header of a datagram, and the largest number of characters of a frame in addition to its words. */
enum { MOST_HEADER = {{ PATH.MOST_AROUND }}, LONGEST_REST = 48 };

/* Lengths of datagrams that are tried in turn, and the number of unanswered openings before the next length. */
static const size_t LENGTHS[] = { {{ PATH.LENGTHS | join(", ") }} };
enum { SHORTEST_LENGTH = {{ PATH.LENGTHS[-1] }}, PATH_TRIES = {{ PATH.TRIES }} };

static const char SESSION_OVER[] = "the gateway was reset, or another program has opened a session with it";

/* The length in bytes of the longest frame that fits into a datagram. */
static size_t longest_frame(const ul_link *link)
{
    size_t fits = link->largest_datagram - MOST_HEADER;
    return link->transport.datagrams && fits < UL_LONGEST_FRAME ? fits : UL_LONGEST_FRAME;
}

/* The number of words that fit into a frame here, at most `words`, the gateway's limit. */
static unsigned most_in_frame(const ul_link *link, unsigned words)
{
    unsigned digits = link->data_digits > link->address_digits ? link->data_digits : link->address_digits;
    unsigned room = (unsigned)(longest_frame(link) - LONGEST_REST) / digits;
    return words < room ? words : room;
}

static void use_length(ul_link *link, size_t largest)
{
    if (largest < SHORTEST_LENGTH / 2) largest = SHORTEST_LENGTH / 2;
    if (largest < link->largest_datagram) link->largest_datagram = largest;
    link->block_words = most_in_frame(link, link->info.block_words);
}

/* Use the length of datagrams that the system knows for the network. */
static void learn_length(ul_link *link)
{
    if (link->transport.longest_datagram != NULL)
        use_length(link, link->transport.longest_datagram(link->transport.context));
}

/* Record that the opening of a session, in a datagram of the present length, was not answered. */
static void shorten_length(ul_link *link)
{
    size_t next = SHORTEST_LENGTH;
    if (link->transport.keeps_length || ++link->long_openings % PATH_TRIES != 0) return;
    for (unsigned index = 0; index < sizeof LENGTHS / sizeof *LENGTHS; index++)
        if (LENGTHS[index] < link->largest_datagram && LENGTHS[index] > next) next = LENGTHS[index];
    if (next < link->largest_datagram) use_length(link, next);
}

static text without_line_ends(text line)
{
    while (line.size > 0 && is_line_end(*line.at)) line = without_first(line, 1);
    return line;
}

/* Remove the end of a frame from the front of `rest`: its CRC and LF, or CR. `start` is the beginning of the frame. */
static bool take_end(const ul_link *link, const char *start, text *rest)
{
    text body = {start, (size_t)(rest->at - start)};
    uint64_t check;
    if (rest->size > 0 && *rest->at == PLAIN_END) {
        *rest = without_first(*rest, rest->size > 1 && rest->at[1] == CHECKED_END ? 2 : 1);
        return true;
    }
    if (link->crc_digits == 0 || !take_number(rest, link->crc_digits, &check) || check != check_of(link, body, 0)) return false;
    if (rest->size == 0 || *rest->at != CHECKED_END) return false;
    *rest = without_first(*rest, 1);
    return true;
}

static bool is_refusal(const ul_link *link, text frames)
{
    text rest = frames = without_line_ends(frames);
    if (!take_prefix(link, &rest) || !starts_with(rest, "X0A")) return false;
    rest = without_first(rest, 3);
    return take_end(link, frames.at, &rest);
}

/* Whether a datagram is newer than all before, by its count; the count 00000000 is outside of the sequence. */
static bool takes_count(ul_link *link, uint32_t count)
{
    uint32_t ahead = count - link->taken_datagrams;
    if (count == 0 || ahead == 0 || ahead > UINT32_MAX >> 1) return false;
    link->taken_datagrams = count;
    return true;
}

/* Whether the frames of a datagram, with its session and count, are for this link. If the gateway reports that the
 * session is over, end the link. */
static bool takes_datagram(ul_link *link, uint32_t session, uint32_t count, text frames)
{
    bool refused = count == 0 && is_refusal(link, frames);
    if (link->datagram_session == 0) {
        if (count != 0 || session == 0 || refused) return false;
        link->offer = session;
        return true;
    }
    if (session != link->datagram_session) return false;
    if (refused) lose(link, SESSION_OVER);
    return takes_count(link, count);
}

/* Replace a datagram by those of its frames that are for this link, and return their size in bytes. */
static size_t take_datagram(ul_link *link, char *at, size_t size)
{
    text start = without_line_ends((text){at, size}), frames = start;
    uint64_t session, count;
    if (take_prefix(link, &frames) && starts_with(frames, "U")) {
        frames = without_first(frames, 1);
        if (!take_number(&frames, 8, &session) || !take_number(&frames, 8, &count)) return 0;
        if (!take_end(link, start.at, &frames)) return 0;
        if (!takes_datagram(link, (uint32_t)session, (uint32_t)count, frames)) return 0;
    } else if (link->datagram_session != 0) {
        return 0;
    } else {
        frames = start;     /* from a gateway with an earlier version of the protocol, which reports its version */
    }
    size_t left = frames.size;
    memmove(at, frames.at, left);
    if (left == 0 || left == size || (link->compact && at[left - 1] == (char)COMPACT_END)) return left;
    /* Add an end to a frame that was truncated at the end of its datagram, so that it does not damage the next
     * frame. */
    if (at[left - 1] != CHECKED_END) at[left++] = CHECKED_END;
    return left;
}

/* The number of bytes of complete frames that fit into a datagram; at least one frame. */
static size_t piece_of(text frames, size_t room)
{
    size_t end = 0;
    for (size_t index = 0; index < frames.size && (index < room || end == 0); index++)
        if (is_line_end(frames.at[index]) || frames.at[index] == (char)COMPACT_END) end = index + 1;
    return end == 0 ? frames.size : end;
}

/* Whether frames can be sent. The first `K` opens the offered session; without an offer, the frames count as lost. */
static bool opens_session(ul_link *link, text frames)
{
    text first = without_line_ends(frames);
    if (link->datagram_session != 0 || !take_prefix(link, &first) || !starts_with(first, "K")) return true;
    link->datagram_session = link->offer;
    link->sent_datagrams = link->taken_datagrams = 0;
    return link->datagram_session != 0;
}

/* Send the frames from `from` on that fit into a datagram. The result is that of the transport's `send`. */
static ptrdiff_t send_datagram(ul_link *link, const char *from, size_t size)
{
    char datagram[MOST_HEADER + UL_LONGEST_FRAME], *at = datagram;
    text frames = {from, piece_of((text){from, size}, link->largest_datagram - MOST_HEADER)};
    ptrdiff_t consumed = (ptrdiff_t)frames.size, sent;
    if (!opens_session(link, frames)) return consumed;
    uint32_t count = link->sent_datagrams == UINT32_MAX ? 1 : link->sent_datagrams + 1;
    if (link->datagram_session != 0) {
        frames = without_line_ends(frames);
        if (frames.size == 0) return consumed;
        at = put_number(put_text(put_prefix(link, at), "U"), 8, link->datagram_session);
        at = put_check(link, put_number(at, 8, count), datagram);
    }
    memcpy(at, frames.at, frames.size);
    sent = link->transport.send(link->transport.context, datagram, (size_t)(at - datagram) + frames.size);
    if (sent > 0 && link->datagram_session != 0) link->sent_datagrams = count;
    return sent > 0 ? consumed : sent;
}
