/* Takes samples of one group at given times, and prints their sequence numbers, losses and times.
 *
 * Arguments: the gateway's clock in Hz, and the rate in Hz. Lines: the time in seconds, and the body of a sample. */
#include "unity_link.c"
#include <inttypes.h>
#include <stdlib.h>

static double told_time(void *context)
{
    return *(double *)context;
}

int main(int count, char **arguments)
{
    if (count != 3) return 1;
    static double now;
    static char line[256];
    static uint64_t storage[UL_STORAGE(4, 1)];
    static ul_link link;
    static ul_subscription group;
    link.transport.now = told_time;
    link.transport.context = &now;
    link.info.clock_hz = (uint32_t)strtoul(arguments[1], NULL, 10);
    link.data_digits = 8;
    link.subscriptions = &group;
    group.count = 1;
    group.flags = PERIODIC | TIMESTAMP;
    group.actual_rate_hz = strtod(arguments[2], NULL);
    group.storage = storage;
    group.capacity = 3;
    group.sequence = UINT64_MAX;
    while (fgets(line, sizeof line, stdin) != NULL) {
        char *body;
        ul_sample sample;
        now = strtod(line, &body);
        while (*body == ' ') body++;
        take_sample(&link, (text){body + 1, strcspn(body, "\n") - 1});
        if (!give_sample(&link, &group, &sample)) return 2;
        printf("%" PRIu64 " %" PRIu64 " %.17g\n", sample.sequence, sample.lost, sample.time);
    }
    return 0;
}
