/* The medium of a fuzzed client: the input controls its gateway, and time is simulated.
 *
 * By default the gateway answers each request as one with memory at all addresses, so that an input gets beyond the
 * opening. Each wait of the client takes a byte of the input, which chooses the bytes that arrive instead: bytes of the
 * input, frames with a valid CRC and any content, parts of answers, damaged or lost answers, samples, no bytes, or the
 * end of the line. */
#ifndef MEDIUM_H
#define MEDIUM_H

#include "unity_link.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HAS_TO_HOLD(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition); \
            abort(); \
        } \
    } while (0)

enum { LINE_SIZE = 1 << 14, WAITING_SIZE = 1 << 16, MOST_WAITS = 3000 };

static const uint8_t *input;
static size_t input_left;

static unsigned next_byte(void)
{
    if (input_left == 0) return 0;
    input_left--;
    return *input++;
}

static uint64_t next_number(unsigned bytes)
{
    uint64_t number = 0;
    for (; bytes > 0; bytes--) number = number << 8 | next_byte();
    return number;
}

/* The configuration and the state of the gateway. */
static ul_info info;
static int node;
static bool is_open, is_gone;
static unsigned waits, most_at_once;
static double the_time;
static char line[LINE_SIZE], waiting[WAITING_SIZE];
static size_t line_size, waiting_size, allowed_size;
static uint64_t last_id;
static uint32_t session;
static unsigned group, group_flags, group_words;

static unsigned digits_of(unsigned bits)
{
    return (bits + 3) / 4;
}

static void say(const char *bytes, size_t size)
{
    if (size > sizeof waiting - waiting_size) size = sizeof waiting - waiting_size;
    memcpy(waiting + waiting_size, bytes, size);
    waiting_size += size;
}

static char *put_digits(char *at, unsigned digits, uint64_t number)
{
    for (unsigned index = digits; index-- > 0; number >>= 4) at[index] = "0123456789ABCDEF"[number & 15];
    return at + digits;
}

/* Return the CRC of a gateway's frame; after the prefix it depends on the number of the session. */
static uint32_t crc_of(const char *bytes, size_t size)
{
    size_t prefix = node >= 0 ? 3 : 0;
    bool belongs = size > prefix && ((bytes[prefix] >= 'g' && bytes[prefix] <= 'z') || bytes[prefix] == 'P');
    uint64_t seed = belongs && session != 0 ? 2 * session + 1 : 0;
    uint64_t rest = 0, top = (uint64_t)1 << (info.crc_bits - 1), mask = 2 * top - 1;
    for (size_t index = 0; index < size; index++) {
        if (index == prefix) rest ^= seed;
        rest ^= (uint64_t)(unsigned char)bytes[index] << (info.crc_bits - 8);
        for (int bit = 0; bit < 8; bit++) rest = (rest & top ? rest << 1 ^ info.crc_polynomial : rest << 1) & mask;
    }
    return (uint32_t)rest;
}

/* Send a body in a frame with a valid CRC. */
static void say_checked(const char *body, size_t size)
{
    static char frame[LINE_SIZE + 16];
    char *at = frame;
    if (size > LINE_SIZE) size = LINE_SIZE;
    if (node >= 0) {
        *at++ = 'Z';
        at = put_digits(at, 2, (unsigned)node);
    }
    memcpy(at, body, size);
    at += size;
    at = put_digits(at, info.crc_bits / 4, crc_of(frame, (size_t)(at - frame)));
    *at++ = '\n';
    say(frame, (size_t)(at - frame));
}

static char *put_info(char *at)
{
    *at++ = 'Q';
    at = put_digits(at, 2, info.version);
    at = put_digits(at, 2, info.data_bits);
    at = put_digits(at, 2, info.address_bits);
    at = put_digits(at, 2, info.id_digits);
    at = put_digits(at, 2, info.crc_bits);
    at = put_digits(at, 8, info.crc_polynomial);
    at = put_digits(at, 2, info.block_words);
    at = put_digits(at, 4, info.groups);
    at = put_digits(at, 2, info.group_words);
    at = put_digits(at, 10, info.base_frequency_millihertz);
    at = put_digits(at, 8, info.clock_hz);
    at = put_digits(at, 4, info.receive_fifo_bytes);
    at = put_digits(at, 4, info.transmit_fifo_bytes);
    at = put_digits(at, 4, info.features);
    return put_digits(at, 8, info.build_id);
}

static uint64_t read_digits(const char *at, size_t size, size_t first, unsigned digits)
{
    uint64_t number = 0;
    for (size_t index = first; index < first + digits && index < size; index++) {
        const char *digit = strchr("0123456789ABCDEF", at[index]);
        number = number << 4 | (digit == NULL || *digit == '\0' ? 0 : (uint64_t)(digit - "0123456789ABCDEF"));
    }
    return number;
}

/* Answer a request with an ID. */
static void answer(const char *body, size_t size)
{
    static char reply[LINE_SIZE];
    unsigned data = digits_of(info.data_bits), address = digits_of(info.address_bits);
    size_t letters = size > 1 && body[1] >= 'g' ? 2 : 1, head = letters + info.id_digits;
    if (size < head) return;
    last_id = read_digits(body, size, letters, info.id_digits);
    uint64_t words = 0;
    if (body[0] == 'w' && body[1] == 's') return;
    if (body[0] == 'r') words = letters == 1 ? 1 : read_digits(body, size, head + address, 2);
    if (body[0] == 'w' && body[1] == 'k') words = 1;
    if (body[0] == 'g' && body[1] == 's') {
        group = (unsigned)read_digits(body, size, head, 2);
        group_flags = (unsigned)read_digits(body, size, head + 2, 2);
        group_words = (unsigned)read_digits(body, size, head + 8, 2);
    }
    memcpy(reply, body, head);
    char *at = reply + head;
    for (uint64_t index = 0; index < words; index++) at = put_digits(at, data, index * 0x9E3779B97F4A7C15u);
    if (body[0] == 'h') at = put_digits(at, info.id_digits, 0);
    say_checked(reply, (size_t)(at - reply));
}

/* Answer `K`, with fields or without. */
static void answer_session(const char *body, size_t size)
{
    char reply[32], *at = reply;
    unsigned digits = info.crc_bits == 8 ? 2 : 4;
    uint32_t before = session;
    if (size == 1 || size != 1 + info.id_digits + digits) {
        *at++ = 'K';
    } else {
        session = (uint32_t)read_digits(body, size, 1 + info.id_digits, digits);
        memcpy(at, body, size);
        at += size;
    }
    at = put_digits(at, digits, before);
    say_checked(reply, (size_t)(at - reply));
}

static void hear_line(char end)
{
    char *body = line;
    size_t size = line_size;
    char reply[128];
    if (node >= 0 && size >= 3) {
        body += 3;
        size -= 3;
    }
    if (end == '\r' && size == 1 && body[0] == 'Q') {
        char *at = reply;
        if (node >= 0) {
            *at++ = 'Z';
            at = put_digits(at, 2, (unsigned)node);
        }
        at = put_info(at);
        *at++ = '\r';
        *at++ = '\n';
        say(reply, (size_t)(at - reply));
    }
    if (end != '\n' || size <= info.crc_bits / 4) return;
    size -= info.crc_bits / 4;
    if (body[0] == 'Q') say_checked(reply, (size_t)(put_info(reply) - reply));
    else if (body[0] == 'K') answer_session(body, size);
    else if (body[0] >= 'g' && body[0] <= 'z') answer(body, size);
}

/* Arriving bytes ------------------------------------------------------------------------------------------------ */

static void let_arrive(size_t size)
{
    allowed_size = size < waiting_size - allowed_size ? allowed_size + size : waiting_size;
}

/* Take bytes of the input for a body, unchanged or as digits; return their number. */
static size_t take_body(char *body, size_t most, bool as_digits)
{
    size_t size = next_byte() % most;
    if (size > input_left) size = input_left;
    for (size_t index = 0; index < size; index++) {
        unsigned byte = next_byte();
        body[index] = as_digits ? "0123456789ABCDEF"[byte & 15] : (char)byte;
    }
    return size;
}

static void say_named(void)
{
    static const char *const COMMANDS[] = {"r", "rm", "rq", "w", "wm", "wq", "wk", "h", "gs", "gn", "gx", "gp", "i", "n", "x", "ws"};
    static const unsigned char LENGTHS[] = {0, 1, 2, 3, 4, 8, 16, 40};
    char body[64], *at = body;
    unsigned choice = next_byte();
    const char *command = COMMANDS[choice & 15];
    at += strlen(strcpy(at, command));
    at = put_digits(at, info.id_digits, last_id + (uint64_t)(int64_t)(int8_t)next_byte());
    unsigned digits = LENGTHS[choice >> 4 & 7];
    at = put_digits(at, digits, digits > 0 ? next_number(2) : 0);
    say_checked(body, (size_t)(at - body));
}

static void say_sample(void)
{
    static char body[1 << 13];
    char *at = body;
    *at++ = 'P';
    at = put_digits(at, 2, group);
    at = put_digits(at, 2, next_byte());
    if (group_flags & 8) at = put_digits(at, 8, next_number(4));
    unsigned data = digits_of(info.data_bits);
    for (unsigned index = 0; index < group_words % 256; index++) at = put_digits(at, data, next_byte());
    say_checked(body, (size_t)(at - body));
}

/* Perform the action of a byte of the input; return true if the client waits for its whole time. */
static bool act(void)
{
    char body[256];
    unsigned choice = next_byte();
    switch (choice % 16) {
    case 0: return true;
    case 1: say(body, take_body(body, sizeof body, false)); break;
    case 2: say_checked(body, take_body(body, sizeof body, false)); break;
    case 3: say_checked(body, take_body(body, sizeof body, true)); break;
    case 4: say_named(); break;
    case 5: say_sample(); break;
    case 6: let_arrive(next_byte()); return false;
    case 7:
        if (waiting_size > allowed_size) waiting[allowed_size + next_byte() % (waiting_size - allowed_size)] ^= (char)(1 << choice / 32);
        break;
    case 8: waiting_size = allowed_size; return true;
    case 9: is_gone = next_byte() == 0xFF; break;
    case 10: snprintf(body, sizeof body, "X%02X", next_byte() % 16); say_checked(body, 3); break;
    case 11: the_time += 0.001 * next_byte(); return false;
    default: break;
    }
    let_arrive(SIZE_MAX);
    return false;
}

/* Calls of the client ---------------------------------------------------------------------------------------------- */

/* Assert that the client does not use a closed medium. */
static void use(void)
{
    HAS_TO_HOLD(is_open);
}

static ptrdiff_t take_from_client(void *context, const void *bytes, size_t size)
{
    (void)context;
    use();
    if (is_gone) return -1;
    if (most_at_once && size > most_at_once) size = next_byte() % 4 == 3 ? 0 : most_at_once;
    for (size_t index = 0; index < size; index++) {
        char byte = ((const char *)bytes)[index];
        if (byte == '\n' || byte == '\r') {
            hear_line(byte);
            line_size = 0;
        } else if (line_size < sizeof line) {
            line[line_size++] = byte;
        }
    }
    return (ptrdiff_t)size;
}

static ptrdiff_t give_to_client(void *context, void *bytes, size_t size)
{
    (void)context;
    use();
    if (is_gone) return -1;
    if (size > allowed_size) size = allowed_size;
    if (most_at_once && size > most_at_once) size = most_at_once;
    memcpy(bytes, waiting, size);
    memmove(waiting, waiting + size, waiting_size - size);
    waiting_size -= size;
    allowed_size -= size;
    return (ptrdiff_t)size;
}

static void wait_for_gateway(void *context, bool sending, double seconds)
{
    (void)context, (void)sending;
    use();
    HAS_TO_HOLD(seconds > 0);
    if (++waits > MOST_WAITS) is_gone = true;
    bool passes;
    if (input_left > 0) {
        passes = act();
    } else {
        passes = waiting_size == 0;
        let_arrive(SIZE_MAX);
    }
    the_time += passes ? seconds : 0.0001;
}

static double read_clock(void *context)
{
    (void)context;
    use();
    return the_time;
}

static void close_medium(void *context)
{
    (void)context;
    use();
    is_open = false;
}

/* Return a medium whose gateway has the configuration that the input chooses. */
static ul_transport open_medium(void)
{
    static const unsigned char DATA[] = {32, 8, 12, 13, 33, 63, 64, 16}, ADDRESS[] = {8, 12, 16, 17, 24, 31, 32, 9};
    static const unsigned char BLOCK[] = {255, 1, 7, 64}, GROUPS[] = {8, 0, 1, 4}, GROUP_WORDS[] = {255, 0, 1, 16};
    static const struct { unsigned bits; uint32_t polynomial; } CHECKS[] = {
        {16, 0x1021}, {8, 0x07}, {32, 0x04C11DB7}, {16, 0x8005}};
    unsigned widths = next_byte(), sizes = next_byte(), others = next_byte();
    memset(&info, 0, sizeof info);
    info.version = 3;
    info.data_bits = DATA[widths & 7];
    info.address_bits = ADDRESS[widths >> 3 & 7];
    info.crc_bits = CHECKS[widths >> 6].bits;
    info.crc_polynomial = CHECKS[widths >> 6].polynomial;
    info.block_words = BLOCK[sizes & 3];
    info.groups = GROUPS[sizes >> 2 & 3];
    info.group_words = GROUP_WORDS[sizes >> 4 & 3];
    info.receive_fifo_bytes = sizes & 64 ? 64 : 1024;
    info.id_digits = sizes & 128 ? 2 : 3;
    info.base_frequency_millihertz = others & 1 ? 1000000 : others & 2 ? 0xFFFFFFFFFF : 1;
    info.clock_hz = others & 4 ? 50000000 : others & 8 ? 1 : 0xFFFFFFFF;
    info.features = others & 16 ? 0x017F : (unsigned)next_number(2);
    node = others & 32 ? 5 : -1;
    most_at_once = others & 64 ? 1 + next_byte() : 0;
    is_open = true;
    is_gone = false;
    waits = 0;
    session = 0;
    line_size = waiting_size = allowed_size = 0;
    group = group_flags = group_words = 0;
    ul_transport medium;
    memset(&medium, 0, sizeof medium);
    medium.send = take_from_client;
    medium.receive = give_to_client;
    medium.wait = wait_for_gateway;
    medium.now = read_clock;
    medium.close = close_medium;
    medium.shortest_timeout = others & 128 ? 0.002 : 0;
    return medium;
}

static void begin_input(const uint8_t *data, size_t size)
{
    input = data;
    input_left = size;
    the_time = 0;
    is_open = false;
}

#endif
