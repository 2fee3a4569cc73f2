/* The other end of the benchmarks: a gateway that uses very little processor time, so that the host is measured.
 *
 * It implements the wire protocol in checked form (words of 32 bits, addresses of at most 16): r, rm, w, wm, ws, h and
 * the group commands on plain memory. It trusts the line: its own frames have the session in their CRC, but it checks
 * neither CRCs nor IDs, and reports no errors.
 * Active groups publish in turn, as fast as the line transfers, without timestamps. If the session requests it, frames
 * are in the compact form.
 *
 * usage: responder FD CONFIGURATION     (the answer to Q, which also sets the widths)
 *
 * FD is an open pseudo-terminal or stream socket, a listening socket, which serves one host after the other, or a
 * datagram socket. It relies on datagrams not being late.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

enum { DATA = 8, MOST = 1 << 16, WORDS = 1 << 16, PUBLISHES = 256, GROUPS = 256, DATAGRAM = 1400, HEADER = 32, AT_ONCE = 4096 };

static uint32_t crc_table[256];
static uint32_t memory[WORDS];
static char out[MOST * 4];
static size_t out_length;
static const char *configuration;
static int fd, id_digits, address_digits, crc_bits;
static struct group {
    int words, sequence;
    uint16_t addresses[256];
} groups[GROUPS];
static int running, turn;
static uint8_t runs[GROUPS];
static int compact; /* of the current session */
static int datagrams, asked, asked_plainly;
static uint32_t number; /* of the current session, 0 if there is none */
static uint32_t session, offer = 1, sent_datagrams;
static uint32_t offered; /* in the header of the present datagram */
static struct sockaddr_storage host;
static socklen_t host_length;

static const char digit[] = "0123456789ABCDEF";

/* The compact form: its special bytes, and the commands that have it, in the order of their numbers. */
enum { START = 0xB5, END = 0xCA, ESCAPE = 0xD3, STUFFED = 0x40 };
static const char *const commands[] = {"r", "rm", "rq", "w",  "wm", "wq", "wk", "ws",
                                       "h", "gn", "gx", "gp", "i",  "n",  "x",  "P"};

/* A CRC of any width is stored in the upper bits of a word of 32 bits, so that one table is enough. */
static void make_table(uint32_t polynomial)
{
    for (uint32_t byte = 0; byte < 256; byte++) {
        uint32_t crc = byte << 24;
        for (int bit = 0; bit < 8; bit++)
            crc = crc & 0x80000000u ? crc << 1 ^ polynomial : crc << 1;
        crc_table[byte] = crc;
    }
}

static void put_hex(uint32_t value, int digits)
{
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        out[out_length++] = digit[value >> shift & 15];
}

static void put(const char *text, size_t length)
{
    memcpy(out + out_length, text, length);
    out_length += length;
}

static uint32_t get_hex(const char *text, int digits)
{
    uint32_t value = 0;
    for (int i = 0; i < digits; i++)
        value = value << 4 | (uint32_t)(text[i] <= '9' ? text[i] - '0' : text[i] - 'A' + 10);
    return value;
}

/* Convert the frame that begins at `start` to the compact form, if it has one. An odd number of digits is padded with
 * one digit. */
static void pack(size_t start)
{
    static char text[MOST];
    size_t letters = out[start + 1] > 'F' ? 2 : 1, length = out_length - 1 - start, held;
    uint32_t command = 0;

    while (strlen(commands[command]) != letters || memcmp(commands[command], out + start, letters) != 0)
        if (++command == sizeof commands / sizeof *commands)
            return;
    text[0] = digit[command];
    text[1] = '0';
    held = 2 - (length - letters) % 2;
    memcpy(text + held, out + start + letters, length - letters);
    held += length - letters;
    out_length = start;
    out[out_length++] = (char)START;
    for (size_t at = 0; at < held; at += 2) {
        uint32_t byte = get_hex(text + at, 2);
        if (byte == START || byte == END || byte == ESCAPE || byte == '\n' || byte == '\r') {
            out[out_length++] = (char)ESCAPE;
            byte ^= STUFFED;
        }
        out[out_length++] = (char)byte;
    }
    out[out_length++] = (char)END;
}

/* Return the text of a compact frame (from its start byte, without its end byte), and its length. */
static const char *unpack(const char *frame, size_t *length)
{
    static char text[MOST * 2];
    char *to = text;
    uint8_t first = (uint8_t)frame[1];
    size_t from = 1;

    if (first == ESCAPE)
        first = (uint8_t)frame[++from] ^ STUFFED;
    const char *command = commands[first >> 4];
    int addressed = command[0] == 'r' || command[0] == 'w';
    int odd = (1 + id_digits + crc_bits / 4 + (addressed ? address_digits : 0)) % 2;
    while (*command)
        *to++ = *command++;
    if (!odd)
        *to++ = digit[first & 15];
    for (size_t at = from + 1; at < *length; at++) {
        uint8_t byte = (uint8_t)frame[at];
        if (byte == ESCAPE)
            byte = (uint8_t)frame[++at] ^ STUFFED;
        *to++ = digit[byte >> 4];
        *to++ = digit[byte & 15];
    }
    *to = '\n';
    *length = (size_t)(to - text);
    return text;
}

/* The CRC of samples and of answers with an ID includes the session. */
static void end_frame(size_t start)
{
    int seeded = number && (out[start] > 'Z' || out[start] == 'P');
    uint32_t crc = seeded ? (2 * number + 1) << (32 - crc_bits) : 0;
    for (size_t i = start; i < out_length; i++)
        crc = crc_table[crc >> 24 ^ (uint8_t)out[i]] ^ crc << 8;
    put_hex(crc >> (32 - crc_bits), crc_bits / 4);
    out[out_length++] = '\n';
    if (seeded && compact)
        pack(start);
}

/* The header is built in the buffer after the frames, but sent before them. Answers outside of a session have count 0. */
static void send_datagram(const char *frames, size_t length)
{
    size_t start = out_length;
    put("U", 1);
    put_hex(asked ? offer : session, 8);
    put_hex(asked ? 0 : ++sent_datagrams, 8);
    if (asked_plainly)
        put("\r\n", 2);
    else
        end_frame(start);
    struct iovec parts[] = {{out + start, out_length - start}, {(void *)frames, length}};
    struct msghdr message = {.msg_name = &host, .msg_namelen = host_length, .msg_iov = parts, .msg_iovlen = 2};
    sendmsg(fd, &message, 0);
    out_length = start;
}

static void send_datagrams(void)
{
    const char *end = out + out_length, *from = out, *to = out;
    while (to < end) {
        const char *next = to;
        while (*next != '\n' && (uint8_t)*next != END)
            next++;
        next++;
        if (to > from && next - from > DATAGRAM - HEADER) {
            send_datagram(from, (size_t)(to - from));
            from = to;
        }
        to = next;
    }
    if (to > from)
        send_datagram(from, (size_t)(to - from));
}

/* Write errors are ignored: if the other end has gone, the next read reports it. */
static void flush(void)
{
    size_t sent = 0;
    if (datagrams)
        send_datagrams();
    while (!datagrams && sent < out_length) {
        ssize_t n = write(fd, out + sent, out_length - sent);
        if (n < 0 && errno != EINTR)
            break;
        if (n > 0)
            sent += (size_t)n;
    }
    out_length = 0;
}

/* Read the fields of the answer to Q: version, data bits, address bits, ID digits, CRC bits, polynomial, ... */
static void configure(const char *text)
{
    configuration = text;
    address_digits = (int)(get_hex(text + 4, 2) + 3) / 4;
    id_digits = (int)get_hex(text + 6, 2);
    crc_bits = (int)get_hex(text + 8, 2);
    make_table(get_hex(text + 10, 8) << (32 - crc_bits));
}

/* Start or stop a group. */
static void run(uint8_t group, int on)
{
    int others = 0;
    for (int i = 0; i < running; i++)
        if (runs[i] != group)
            runs[others++] = runs[i];
    running = others;
    if (on)
        runs[running++] = group;
}

static void answer(const char *frame, size_t length)
{
    size_t start = out_length;
    int letters = frame[1] > 'F' ? 2 : 1;
    const char *fields = frame + letters + id_digits;
    uint32_t address;

    if (frame[0] == 'Q' || frame[0] == 'K') {
        int session_digits = crc_bits == 8 ? 2 : 4, opening = id_digits + session_digits;
        size_t fields_length = length - 1 - (frame[length] == '\r' ? 0 : (size_t)crc_bits / 4);
        uint32_t ended = number;
        put(frame, 1);
        if (frame[0] == 'Q')
            put(configuration, strlen(configuration));
        else if (fields_length > 0) {
            put(frame + 1, (size_t)opening);
            uint32_t asks_compact = 1u << (4 * session_digits - 1);
            number = get_hex(frame + 1 + id_digits, session_digits);
            compact = (number & asks_compact) != 0;
            number &= asks_compact - 1;
            running = 0;
            if (!asked) {
                session = offered;
                offer = session + 1;
                sent_datagrams = 0;
            }
        }
        if (frame[0] == 'K')
            put_hex(ended, session_digits);
        if (frame[length] == '\r')
            put("\r\n", 2);
        else
            end_frame(start);
        return;
    }
    if (frame[0] == 'w' && frame[1] == 's') {
        memory[get_hex(fields, address_digits)] = get_hex(fields + address_digits, DATA);
        return;
    }
    put(frame, (size_t)(letters + id_digits));
    if (frame[0] == 'r') {
        address = get_hex(fields, address_digits);
        uint32_t count = letters == 2 ? get_hex(fields + address_digits, 2) : 1;
        for (uint32_t i = 0; i < count; i++)
            put_hex(memory[(address + i) & (WORDS - 1)], DATA);
    } else if (frame[0] == 'w') {
        address = get_hex(fields, address_digits);
        for (const char *word = fields + address_digits; word + DATA <= frame + length - crc_bits / 4; word += DATA)
            memory[address++ & (WORDS - 1)] = get_hex(word, DATA);
    } else if (frame[0] == 'g' && frame[1] == 's') {
        struct group *set = &groups[get_hex(fields, 2)];
        set->words = (int)get_hex(fields + 8, 2);
        for (int i = 0; i < set->words; i++)
            set->addresses[i] = (uint16_t)get_hex(fields + 10 + address_digits * i, address_digits);
        set->sequence = 0;
    } else if (frame[0] == 'h') {
        put_hex(0, id_digits);
    } else if (frame[0] == 'g') {
        run((uint8_t)get_hex(fields, 2), frame[1] == 'n');
    }
    end_frame(start);
}

/* Publish samples of the active groups in turn. */
static void publish(void)
{
    for (int n = 0; n < PUBLISHES && out_length < AT_ONCE; n++) {
        size_t start = out_length;
        turn = (turn + 1) % running;
        struct group *is = &groups[runs[turn]];
        out[out_length++] = 'P';
        put_hex(runs[turn], 2);
        put_hex((uint32_t)is->sequence++ & 255, 2);
        for (int i = 0; i < is->words; i++)
            put_hex(memory[is->addresses[i]], DATA);
        end_frame(start);
    }
}

/* Read bytes; from a datagram, only the frames after its header. */
static ssize_t receive(char *in, size_t room)
{
    if (!datagrams)
        return read(fd, in, room);
    host_length = sizeof host;
    ssize_t n = recvfrom(fd, in, room, 0, (struct sockaddr *)&host, &host_length);
    char *frames = n > 0 && in[0] == 'U' ? memchr(in, '\n', (size_t)n) : NULL;
    asked = frames == NULL;
    asked_plainly = asked && n > 0 && in[n - 1] == '\r';
    if (asked)
        return n;
    frames++;
    n -= frames - in;
    offered = get_hex(in + 1, 8);
    memmove(in, frames, (size_t)n);
    return n;
}

/* Answer requests until the other end closes. */
static void serve(void)
{
    static char in[MOST];
    size_t held = 0;

    running = 0;
    for (;;) {
        struct pollfd ready = {fd, POLLIN, 0};
        if (running) {
            publish();
            flush();
        }
        if (poll(&ready, 1, running ? 0 : -1) < 0 && errno != EINTR)
            return;
        if (!(ready.revents & (POLLIN | POLLHUP | POLLERR)))
            continue;
        ssize_t n = receive(in + held, sizeof in - held);
        if (n <= 0)
            return;
        held += (size_t)n;
        char *frame = in;
        for (char *at = in; at < in + held; at++)
            if (*at == '\n' || *at == '\r' || (compact && (uint8_t)*at == END)) {
                size_t length = (size_t)(at - frame);
                const char *text = (uint8_t)*at == END ? unpack(frame, &length) : frame;
                if (length > 0)
                    answer(text, length);
                frame = at + 1;
                if (out_length > AT_ONCE)
                    flush();
            }
        held -= (size_t)(frame - in);
        memmove(in, frame, held);
        flush();
    }
}

static int option(int descriptor, int name)
{
    int value = 0;
    socklen_t size = sizeof value;
    return getsockopt(descriptor, SOL_SOCKET, name, &value, &size) < 0 ? 0 : value;
}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    int given = fd = atoi(argv[1]), at_once = 1;
    configure(argv[2]);
    for (uint32_t i = 0; i < WORDS; i++)
        memory[i] = i * 0x01010101u;
    datagrams = option(given, SO_TYPE) == SOCK_DGRAM;
    if (!option(given, SO_ACCEPTCONN)) {
        serve();
        return 0;
    }
    while ((fd = accept(given, NULL, NULL)) >= 0) {
        setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
        serve();
        close(fd);
    }
}
