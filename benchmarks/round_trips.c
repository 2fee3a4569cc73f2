/* Reads in C over a pseudo-terminal, one after the other; prints the median time of a read in seconds.
 *
 * usage: round_trips bare PATH COUNT REQUEST LENGTH     a fixed request, and an answer of LENGTH bytes, unchecked
 *        round_trips client PATH COUNT                  `ul_read` of the generated client
 */
#define _POSIX_C_SOURCE 200809L
#include "unity_link.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { ADDRESS = 0x0A, WORD = 0x0A0A0A0A, MOST = 1 << 20, LONGEST = 64 };

static double times[MOST];
static ul_link gateway;
static int port;
static size_t request_length, response_length;
static char request[LONGEST];

static int read_bare(void)
{
    char response[LONGEST];
    size_t held = 0;
    ssize_t n;
    if (write(port, request, request_length) != (ssize_t)request_length)
        return 1;
    while (held < response_length) {
        if ((n = read(port, response + held, sizeof response - held)) <= 0)
            return 1;
        held += (size_t)n;
    }
    return 0;
}

static int read_by_client(void)
{
    uint64_t word;
    return ul_read(&gateway, ADDRESS, &word) || word != WORD;
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static int compare(const void *one, const void *other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

static int measure(int (*read_once)(void), int count)
{
    for (int i = 0; i < count; i++) {
        double start = now();
        if (read_once()) {
            fprintf(stderr, "a read has failed\n");
            return 1;
        }
        times[i] = now() - start;
    }
    qsort(times, (size_t)count, sizeof *times, compare);
    printf("%.9f\n", (times[count / 2] + times[(count - 1) / 2]) / 2);
    return 0;
}

int main(int argc, char **argv)
{
    int count = argc > 3 ? atoi(argv[3]) : 0;
    if (count < 1 || count > MOST)
        return 2;
    if (argc == 6 && strcmp(argv[1], "bare") == 0) {
        /* REQUEST has no line end, which is difficult to pass in an argument. */
        request_length = (size_t)snprintf(request, sizeof request, "%s\n", argv[4]);
        response_length = (size_t)atoi(argv[5]);
        if ((port = open(argv[2], O_RDWR | O_NOCTTY)) < 0)
            return 1;
        return measure(read_bare, count);
    }
    char url[4096];
    snprintf(url, sizeof url, "serial:%s", argv[2]);
    if (ul_connect(&gateway, url, 5.0)) {
        fprintf(stderr, "%s\n", ul_error(&gateway));
        return 1;
    }
    return measure(read_by_client, count) || ul_close(&gateway);
}
