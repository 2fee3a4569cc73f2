/* Responders for the peers: they answer the peers' protocols from plain memory, with very little processor time.
 *
 * usage: responders FD PROTOCOL
 *
 *     litex       UART bridge of LiteX: commands 1 (write) and 2 (read), on a stream
 *     ipbus       control packets of IPbus 2.0 with reads and writes, in datagrams
 *     modbus-rtu  functions 3, 6 and 16 in frames with a CRC, on a stream
 *     modbus-tcp  the same after headers with a length, on a listening socket
 *
 * Words have 32 bits. Register 2i of Modbus is the upper half of word i, register 2i + 1 the lower half. The responders
 * trust their medium, and do not answer unknown requests.
 */
#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

enum { MOST = 1 << 16, WORDS = 1 << 16 };

static uint32_t memory[WORDS];
static uint8_t out[4 * MOST];
static size_t out_length;

static void put(uint32_t value, int bytes)
{
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
        out[out_length++] = (uint8_t)(value >> shift);
}

static uint32_t get(const uint8_t *from, int bytes)
{
    uint32_t value = 0;
    for (int i = 0; i < bytes; i++)
        value = value << 8 | from[i];
    return value;
}

/* Each of these functions handles one request, appends its response, and returns the length of the request, or 0 if the
 * request is incomplete. */

static size_t litex(const uint8_t *in, size_t length)
{
    if (length < 6)
        return 0;
    size_t words = in[1], whole = 6 + (in[0] == 1 ? 4 * words : 0);
    uint32_t address = get(in + 2, 4);
    if (length < whole)
        return 0;
    for (size_t i = 0; i < words; i++, address++)
        if (in[0] == 1)
            memory[address % WORDS] = get(in + 6 + 4 * i, 4);
        else
            put(memory[address % WORDS], 4);
    return whole;
}

static size_t modbus(const uint8_t *in, size_t length)
{
    size_t whole = 5;
    uint32_t address, count;
    if (length < whole || (in[0] == 16 && length < (whole = 6 + (size_t)in[5])))
        return 0;
    address = get(in + 1, 2);
    count = get(in + 3, 2);
    put(in[0], 1);
    if (in[0] == 3)
        put(2 * count, 1);
    else
        put(get(in + 1, 4), 4);
    for (uint32_t i = 0; in[0] == 3 && i < count; i++, address++)
        put(memory[address / 2] >> (address % 2 ? 0 : 16) & 0xFFFF, 2);
    for (uint32_t i = 0; in[0] != 3 && i < (in[0] == 6 ? 1 : count); i++, address++) {
        int shift = address % 2 ? 0 : 16;
        uint32_t value = get(in[0] == 6 ? in + 3 : in + 6 + 2 * i, 2);
        memory[address / 2] = (memory[address / 2] & ~(0xFFFFu << shift)) | value << shift;
    }
    return whole;
}

static uint16_t crc_table[256];

static void make_table(void)
{
    for (int byte = 0; byte < 256; byte++) {
        uint16_t crc = (uint16_t)byte;
        for (int bit = 0; bit < 8; bit++)
            crc = crc & 1 ? (uint16_t)(crc >> 1 ^ 0xA001) : crc >> 1;
        crc_table[byte] = crc;
    }
}

static size_t modbus_rtu(const uint8_t *in, size_t length)
{
    size_t start = out_length, whole;
    uint16_t crc = 0xFFFF;
    if (length < 8)
        return 0;
    put(in[0], 1);
    whole = modbus(in + 1, length - 3);
    if (whole == 0) {
        out_length = start;
        return 0;
    }
    for (size_t i = start; i < out_length; i++)
        crc = crc >> 8 ^ crc_table[(crc ^ out[i]) & 255];
    put(crc & 255, 1);
    put(crc >> 8, 1);
    return 1 + whole + 2;
}

static size_t modbus_tcp(const uint8_t *in, size_t length)
{
    if (length < 8 || length < 6 + get(in + 4, 2))
        return 0;
    size_t start = out_length;
    put(get(in, 4), 4);
    put(0, 2);
    put(in[6], 1);
    modbus(in + 7, get(in + 4, 2) - 1);
    size_t answer = out_length - start - 6;
    out[start + 4] = (uint8_t)(answer >> 8);
    out[start + 5] = (uint8_t)answer;
    return 6 + get(in + 4, 2);
}

static uint32_t get_word(const uint8_t *from)
{
    uint32_t value;
    memcpy(&value, from, sizeof value);
    return value;
}

static void put_word(uint32_t value)
{
    memcpy(out + out_length, &value, sizeof value);
    out_length += sizeof value;
}

/* Words have the machine's byte order, and a request is a packet. */
static size_t ipbus(const uint8_t *in, size_t length)
{
    const uint8_t *at = in + 4, *end = in + length;
    if (length < 4 || (get_word(in) & 0xF000000F) != 0x20000000)
        return length;
    put_word(get_word(in));
    while (end - at >= 8) {
        uint32_t header = get_word(at), address = get_word(at + 4), count = header >> 8 & 255, type = header >> 4 & 15;
        at += 8;
        put_word(header & ~15u);
        for (uint32_t i = 0; type == 0 && i < count; i++)
            put_word(memory[(address + i) % WORDS]);
        for (uint32_t i = 0; type == 1 && i < count && end - at >= 4; i++, at += 4)
            memory[(address + i) % WORDS] = get_word(at);
    }
    return length;
}

typedef size_t Handler(const uint8_t *in, size_t length);

static void serve_stream(int fd, Handler *handle)
{
    static uint8_t in[MOST];
    size_t held = 0;
    ssize_t n;
    while ((n = read(fd, in + held, sizeof in - held)) > 0) {
        size_t at = 0, taken, sent = 0;
        held += (size_t)n;
        while ((taken = handle(in + at, held - at)) > 0)
            at += taken;
        memmove(in, in + at, held -= at);
        while (sent < out_length) {
            n = write(fd, out + sent, out_length - sent);
            if (n < 0 && errno != EINTR)
                break;
            if (n > 0)
                sent += (size_t)n;
        }
        out_length = 0;
    }
}

static void serve_datagrams(int fd, Handler *handle)
{
    static uint8_t in[MOST];
    struct sockaddr_storage from;
    for (;;) {
        socklen_t size = sizeof from;
        ssize_t n = recvfrom(fd, in, sizeof in, 0, (struct sockaddr *)&from, &size);
        if (n < 0)
            return;
        out_length = 0;
        handle(in, (size_t)n);
        sendto(fd, out, out_length, 0, (struct sockaddr *)&from, size);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    int fd = atoi(argv[1]), connection, at_once = 1;
    make_table();
    for (uint32_t i = 0; i < WORDS; i++)
        memory[i] = i * 0x01010101u;
    if (strcmp(argv[2], "litex") == 0)
        serve_stream(fd, litex);
    else if (strcmp(argv[2], "modbus-rtu") == 0)
        serve_stream(fd, modbus_rtu);
    else if (strcmp(argv[2], "ipbus") == 0)
        serve_datagrams(fd, ipbus);
    else if (strcmp(argv[2], "modbus-tcp") == 0)
        while ((connection = accept(fd, NULL, NULL)) >= 0) {
            setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
            serve_stream(connection, modbus_tcp);
            close(connection);
        }
    else
        return 2;
    return 0;
}
