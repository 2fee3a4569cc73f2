/* A link whose medium floods it: every read finds more bytes, and time passes only while the link waits.
 *
 * Argument: the bytes that the medium repeats, in hexadecimal digits. Prints for each call its status, how often it has
 * waited for a fiftieth of a second, and the most bytes that it has read between two waits. */
#include "unity_link.c"

static char flood[64];
static size_t flood_size, given;
static unsigned long waits, taken_now, most_taken;
static bool takes_nothing;

static ptrdiff_t send_nowhere(void *context, const void *bytes, size_t size)
{
    (void)context, (void)bytes;
    return takes_nothing ? 0 : (ptrdiff_t)size;
}

static ptrdiff_t receive_flood(void *context, void *bytes, size_t size)
{
    (void)context;
    for (size_t index = 0; index < size; index++) ((char *)bytes)[index] = flood[given++ % flood_size];
    taken_now += size;
    if (taken_now > most_taken) most_taken = taken_now;
    return (ptrdiff_t)size;
}

static void wait_a_while(void *context, bool sending, double seconds)
{
    (void)context, (void)sending, (void)seconds;
    waits++;
    taken_now = 0;
}

static double counted_time(void *context)
{
    (void)context;
    return (double)waits / 50;
}

static void close_nothing(void *context)
{
    (void)context;
}

static void print_call(const char *name, ul_status status)
{
    printf("%s %d %lu %lu\n", name, status, waits, most_taken);
    waits = most_taken = taken_now = 0;
}

int main(int count, char **arguments)
{
    static ul_link link;
    static ul_subscription group;
    static uint64_t storage[UL_STORAGE(4, 1)], word;
    static const ul_transport medium = {.send = send_nowhere, .receive = receive_flood, .wait = wait_a_while,
                                        .now = counted_time, .close = close_nothing};
    ul_sample sample;
    text digits = {arguments[count - 1], strlen(arguments[count - 1])};
    for (uint64_t byte; take_number(&digits, 2, &byte);) flood[flood_size++] = (char)byte;

    print_call("open", ul_open(&link, &medium, -1, 0.1));
    takes_nothing = true;
    print_call("stuck", ul_open(&link, &medium, -1, 0.1));
    takes_nothing = false;

    /* The state after the link was opened. */
    link.transport = medium;
    link.transport.shortest_timeout = QUICK_TIMEOUT;
    link.info = (ul_info){.data_bits = 32, .address_bits = 16, .id_digits = 3, .crc_bits = 16, .crc_polynomial = 0x755B,
                          .block_words = 16, .clock_hz = 1, .features = UL_FEATURE_FLOW_CONTROL};
    use_info(&link);
    start_window(&link, 0, 1e-6, 0.001);
    link.gone = false;
    link.open = true;
    link.end = NULL;
    group.link = &link;
    group.count = 1;
    group.storage = storage;
    group.capacity = 3;

    print_call("poll", ul_poll(&link, 0.1));
    link.subscriptions = &group;
    print_call("next", ul_next(&link, &group, &sample, 0.1));
    print_call("await", ul_await(&link, &group, 2, 0.1));
    print_call("read", ul_read(&link, 1, &word));
    print_call("close", ul_close(&link));
    return 0;
}
