/* A client that a test controls: it reads one command on each line, executes it, and prints the status and the results,
 * or the sentence of the error. Numbers in commands are hexadecimal, except seconds and rates; printed words are
 * decimal. */
#define _POSIX_C_SOURCE 200809L
#include "unity_link.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096, SUBSCRIPTIONS = 4, SAMPLES = 8, CALLED = 256 };

static ul_link the_link;
static ul_subscription subscriptions[SUBSCRIPTIONS];
static uint32_t addresses[SUBSCRIPTIONS][255];
static uint64_t storage[SUBSCRIPTIONS][UL_STORAGE(SAMPLES, 255)];
static uint64_t called[CALLED];
static unsigned calls;

static uint64_t words[MOST];
static uint32_t places[MOST];

static char *rest;

static const char *next_text(void)
{
    char *text = strtok_r(NULL, " \n", &rest);
    return text == NULL ? "" : text;
}

static uint64_t next_number(void)
{
    return strtoull(next_text(), NULL, 16);
}

static size_t next_numbers(void)
{
    size_t count = 0;
    for (char *text; (text = strtok_r(NULL, " \n", &rest)) != NULL && count < MOST; count++)
        words[count] = strtoull(text, NULL, 16);
    return count;
}

static void print_words(const uint64_t *some, size_t count)
{
    for (size_t index = 0; index < count; index++) printf(" %" PRIu64, some[index]);
}

static void finish(ul_status status, const uint64_t *some, size_t count)
{
    printf("%d", status);
    if (status == UL_OK) print_words(some, count);
    else printf(" %s", ul_error(&the_link));
    printf("\n");
    fflush(stdout);
}

/* A medium whose clock and other end belong to the test. To wait, it prints `~`, the most seconds to wait, and the sent
 * bytes; the test answers with the time at the end of the wait, and the bytes that have arrived. */

static char sent[1 << 16], arrived[1 << 16];
static size_t sent_size, arrived_size;
static double the_time;
static bool is_open;

/* The client must not use a closed medium. */
static void use(void *context)
{
    (void)context;
    if (!is_open) abort();
}

static ptrdiff_t send_to_test(void *context, const void *bytes, size_t size)
{
    use(context);
    if (size > sizeof sent - sent_size) size = sizeof sent - sent_size;
    memcpy(sent + sent_size, bytes, size);
    sent_size += size;
    return (ptrdiff_t)size;
}

static ptrdiff_t receive_from_test(void *context, void *bytes, size_t size)
{
    use(context);
    if (size > arrived_size) size = arrived_size;
    memcpy(bytes, arrived, size);
    memmove(arrived, arrived + size, arrived_size -= size);
    return (ptrdiff_t)size;
}

static void wait_for_test(void *context, bool sending, double seconds)
{
    static char answer[1 << 17];
    (void)sending;
    use(context);
    printf("~ %a ", seconds);
    for (size_t index = 0; index < sent_size; index++) printf("%02X", (unsigned char)sent[index]);
    printf("\n");
    fflush(stdout);
    sent_size = 0;
    if (fgets(answer, sizeof answer, stdin) == NULL) exit(1);
    char *at;
    unsigned byte;
    the_time = strtod(answer, &at);
    for (at++; sscanf(at, "%2x", &byte) == 1 && arrived_size < sizeof arrived; at += 2)
        arrived[arrived_size++] = (char)byte;
}

static double time_of_test(void *context)
{
    use(context);
    return the_time;
}

static void end_with_test(void *context)
{
    use(context);
    is_open = false;
    sent_size = arrived_size = 0;
}

static ul_status connect_to(const char *url, double timeout)
{
    ul_transport test = {
        .send = send_to_test,
        .receive = receive_from_test,
        .wait = wait_for_test,
        .now = time_of_test,
        .close = end_with_test,
    };
    if (strncmp(url, "test:", 5)) return ul_connect(&the_link, url, timeout);
    is_open = true;
    char *seed;
    test.shortest_timeout = strtod(url + 5, &seed);
    if (*seed == ':') test.seed = (uint32_t)strtoul(seed + 1, NULL, 16);
    return ul_open(&the_link, &test, -1, timeout);
}

static void called_back(void *context, const ul_sample *sample)
{
    uint64_t *last = context;
    *last = sample->words[0];
    if (calls < CALLED) called[calls++] = sample->sequence;
    /* A callback may use the link. */
    ul_post(&the_link, 0x7F, sample->sequence);
}

static void close_link(void *context, const ul_sample *sample)
{
    (void)context, (void)sample;
    ul_close(&the_link);
}

static void subscribe(void)
{
    static uint64_t last;
    unsigned number = (unsigned)next_number();
    ul_subscription *one = &subscriptions[number];
    memset(one, 0, sizeof *one);
    one->rate_hz = strtod(next_text(), NULL);
    const char *flags = next_text();
    one->timestamps = strchr(flags, 't') != NULL;
    one->on_change = strchr(flags, 'c') != NULL;
    one->trigger = strchr(flags, 'e') != NULL;
    one->immediate = strchr(flags, 'i') != NULL;
    if (strchr(flags, 'd') != NULL) {
        one->divisor = (unsigned)one->rate_hz;
        one->rate_hz = 0;
    }
    if (strchr(flags, '1') != NULL) one->group = 1;
    if (strchr(flags, 'b') != NULL) one->callback = called_back;
    if (strchr(flags, 'z') != NULL) one->callback = close_link;
    one->context = &last;
    one->count = (unsigned)next_numbers();
    for (unsigned index = 0; index < one->count; index++) addresses[number][index] = (uint32_t)words[index];
    one->addresses = addresses[number];
    one->storage = storage[number];
    one->storage_words = UL_STORAGE(SAMPLES, one->count);
    finish(ul_subscribe(&the_link, one), NULL, 0);
}

static void next_sample(void)
{
    ul_subscription *one = &subscriptions[next_number()];
    ul_sample sample;
    ul_status status = ul_next(&the_link, one, &sample, strtod(next_text(), NULL));
    if (status != UL_OK) {
        finish(status, NULL, 0);
        return;
    }
    printf("0 %" PRIu64 " %" PRIu64 " %a", sample.sequence, sample.lost, sample.time);
    print_words(sample.words, one->count);
    printf("\n");
    fflush(stdout);
}

static void await_samples(void)
{
    ul_subscription *one = &subscriptions[next_number()];
    size_t count = next_number();
    finish(ul_await(&the_link, one, count, strtod(next_text(), NULL)), NULL, 0);
}

/* A fence, and the results of the posted writes before it. */
static void print_posts(void)
{
    ul_batch fence = UL_BATCH;
    ul_start_fence(&the_link, &fence);
    uint64_t status = ul_finish(&the_link, &fence);
    ul_batch posts = ul_take_posts(&the_link);
    uint64_t all[] = {status, posts.status, posts.address, posts.failed, posts.unknown, posts.not_executed};
    finish(UL_OK, all, sizeof all / sizeof *all);
}

static void print_end(void)
{
    const char *end = ul_end(&the_link);
    printf("0%s%s\n", end == NULL ? "" : " ", end == NULL ? "" : end);
    fflush(stdout);
}

static void print_statistics(void)
{
    const ul_statistics *is = &the_link.statistics;
    uint64_t all[] = {is->requests, is->responses, is->repetitions, is->timeouts, is->damaged, is->stray};
    finish(UL_OK, all, sizeof all / sizeof *all);
}

static void do_many(bool writes)
{
    size_t count = next_numbers();
    if (writes) {
        for (size_t index = 0; index < count / 2; index++) {
            places[index] = (uint32_t)words[2 * index];
            words[index] = words[2 * index + 1];
        }
        finish(ul_write_many(&the_link, places, words, count / 2), NULL, 0);
        return;
    }
    for (size_t index = 0; index < count; index++) places[index] = (uint32_t)words[index];
    finish(ul_read_many(&the_link, places, words, count), words, count);
}

/* Words at an address: read, written, as a block or a queue. */
static void do_words(const char *command)
{
    uint32_t address = (uint32_t)next_number();
    size_t count = strchr(command, 'r') == command ? next_number() : next_numbers();
    if (!strcmp(command, "rblock")) finish(ul_read_block(&the_link, address, words, count), words, count);
    else if (!strcmp(command, "rqueue")) finish(ul_read_queue(&the_link, address, words, count), words, count);
    else if (!strcmp(command, "wblock")) finish(ul_write_block(&the_link, address, words, count), NULL, 0);
    else finish(ul_write_queue(&the_link, address, words, count), NULL, 0);
}

static void do_word(const char *command)
{
    uint32_t address = (uint32_t)next_number();
    uint64_t word = next_number(), mask = next_number();
    if (!strcmp(command, "read")) finish(ul_read(&the_link, address, &word), &word, 1);
    else if (!strcmp(command, "write")) finish(ul_write(&the_link, address, word), NULL, 0);
    else if (!strcmp(command, "post")) finish(ul_post(&the_link, address, word), NULL, 0);
    else finish(ul_write_masked(&the_link, address, word, mask, &word), &word, 1);
}

/* A read, a write and a read of the same address, in flight together. */
static void do_batch(void)
{
    uint32_t address = (uint32_t)next_number();
    ul_batch batch = UL_BATCH;
    ul_start_read(&the_link, &batch, address, &words[0]);
    ul_start_write(&the_link, &batch, address, next_number());
    ul_start_read(&the_link, &batch, address, &words[1]);
    finish(ul_finish(&the_link, &batch), words, 2);
}

/* Writes of 0, 1, 2... to an address, in flight together, each with its own status. */
static void do_apart(void)
{
    static ul_batch batches[MOST];
    uint32_t address = (uint32_t)next_number();
    size_t count = next_number();
    for (size_t index = 0; index < count; index++) {
        batches[index] = UL_BATCH;
        ul_start_write(&the_link, &batches[index], address, index);
    }
    for (size_t index = 0; index < count; index++) words[index] = ul_finish(&the_link, &batches[index]);
    finish(UL_OK, words, count);
}

static void do_command(const char *command)
{
    if (!strcmp(command, "connect")) {
        const char *url = next_text();
        finish(connect_to(url, strtod(next_text(), NULL)), NULL, 0);
    } else if (strchr("rw", *command) != NULL && (strstr(command, "block") || strstr(command, "queue"))) {
        do_words(command);
    } else if (strstr(command, "many") != NULL) {
        do_many(*command == 'w');
    } else if (!strcmp(command, "batch")) {
        do_batch();
    } else if (!strcmp(command, "apart")) {
        do_apart();
    } else if (!strcmp(command, "fence")) {
        finish(ul_fence(&the_link), NULL, 0);
    } else if (!strcmp(command, "immediate")) {
        finish(ul_send_immediate(&the_link, (unsigned)next_number()), NULL, 0);
    } else if (!strcmp(command, "subscribe")) {
        subscribe();
    } else if (!strcmp(command, "again")) {
        finish(ul_subscribe(&the_link, &subscriptions[next_number()]), NULL, 0);
    } else if (!strcmp(command, "rate")) {
        ul_subscription *one = &subscriptions[next_number()];
        one->rate_hz = strtod(next_text(), NULL);
        finish(UL_OK, NULL, 0);
    } else if (!strcmp(command, "storage")) {
        ul_subscription *one = &subscriptions[next_number()];
        one->storage_words = next_number();
        finish(UL_OK, NULL, 0);
    } else if (!strcmp(command, "publish")) {
        finish(ul_publish(&the_link, &subscriptions[next_number()]), NULL, 0);
    } else if (!strcmp(command, "unsubscribe")) {
        finish(ul_unsubscribe(&the_link, &subscriptions[next_number()]), NULL, 0);
    } else if (!strcmp(command, "next")) {
        next_sample();
    } else if (!strcmp(command, "await")) {
        await_samples();
    } else if (!strcmp(command, "posts")) {
        print_posts();
    } else if (!strcmp(command, "end")) {
        print_end();
    } else if (!strcmp(command, "lost")) {
        finish(UL_OK, &subscriptions[next_number()].lost, 1);
    } else if (!strcmp(command, "poll")) {
        calls = 0;
        ul_status status = ul_poll(&the_link, strtod(next_text(), NULL));
        finish(status, called, calls);
    } else if (!strcmp(command, "statistics")) {
        print_statistics();
    } else if (!strcmp(command, "ports")) {
        finish(UL_OK, &the_link.statistics.set_again, 1);
    } else if (!strcmp(command, "close")) {
        finish(ul_close(&the_link), NULL, 0);
    } else {
        do_word(command);
    }
}

int main(void)
{
    static char line[1 << 16];
    while (fgets(line, sizeof line, stdin) != NULL) {
        const char *command = strtok_r(line, " \n", &rest);
        if (command != NULL) do_command(command);
    }
    return 0;
}
