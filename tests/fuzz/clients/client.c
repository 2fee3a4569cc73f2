/* The client in C, with calls and a gateway that the bytes of an input choose. The memory that is passed to a call is
 * freed when the call returns, so that a sanitizer reports later accesses. */
#include "medium.h"
#include "robot.h"

enum { SUBSCRIPTIONS = 3, MOST_CALLS = 120, MOST_WORDS = 600 };

static ul_link the_link;
static ul_subscription subscriptions[SUBSCRIPTIONS];
static robot_state_subscription feed;
static robot_networks networks;

static void check(ul_status status)
{
    const char *sentence = ul_error(&the_link);
    HAS_TO_HOLD(strlen(sentence) < sizeof the_link.error);
    HAS_TO_HOLD(status == UL_OK || *sentence != '\0');
    HAS_TO_HOLD(*ul_status_text(status) != '\0');
}

/* Return memory of exactly `size` bytes with arbitrary contents. */
static void *lent(size_t size)
{
    void *memory = malloc(size ? size : 1);
    HAS_TO_HOLD(memory != NULL);
    memset(memory, 0xA5, size);
    return memory;
}

static uint32_t next_address(void)
{
    return (uint32_t)next_number(next_byte() % 8 == 7 ? 4 : 1);
}

static uint64_t next_word(void)
{
    return next_number(next_byte() % 8 == 7 ? 8 : 1);
}

static size_t next_count(void)
{
    unsigned count = next_byte();
    return count < 200 ? count % 20 : count % 8 * (MOST_WORDS / 8);
}

static void call_words(unsigned choice)
{
    uint32_t address = next_address();
    uint64_t *word = (uint64_t *)lent(sizeof *word);
    switch (choice % 4) {
    case 0: check(ul_read(&the_link, address, word)); break;
    case 1: check(ul_write(&the_link, address, next_word())); break;
    case 2: check(ul_post(&the_link, address, next_word())); break;
    default: check(ul_write_masked(&the_link, address, next_word(), next_word(), choice & 8 ? word : NULL));
    }
    free(word);
}

static void call_block(unsigned choice)
{
    uint32_t address = next_address();
    size_t count = next_count();
    uint64_t *words = (uint64_t *)lent(count * sizeof *words);
    for (size_t index = 0; index < count; index++) words[index] = index & 0xFF;
    switch (choice % 4) {
    case 0: check(ul_read_block(&the_link, address, words, count)); break;
    case 1: check(ul_write_block(&the_link, address, words, count)); break;
    case 2: check(ul_read_queue(&the_link, address, words, count)); break;
    default: check(ul_write_queue(&the_link, address, words, count));
    }
    free(words);
}

static void call_many(bool writes)
{
    size_t count = next_count();
    uint64_t *words = (uint64_t *)lent(count * sizeof *words);
    uint32_t *addresses = (uint32_t *)lent(count * sizeof *addresses);
    for (size_t index = 0; index < count; index++) {
        addresses[index] = (uint32_t)(index & 0xFF);
        words[index] = index & 0xFF;
    }
    check((writes ? ul_write_many(&the_link, addresses, words, count) : ul_read_many(&the_link, addresses, words, count)));
    free(addresses);
    free(words);
}

static void call_batch(void)
{
    ul_batch *batch = (ul_batch *)lent(sizeof *batch);
    uint64_t *words = (uint64_t *)lent(20 * sizeof *words);
    *batch = UL_BATCH;
    for (unsigned count = next_byte() % 20; count-- > 0;) {
        switch (next_byte() % 5) {
        case 0: ul_start_read(&the_link, batch, next_address(), &words[count]); break;
        case 1: ul_start_write(&the_link, batch, next_address(), next_word()); break;
        case 2: ul_start_fence(&the_link, batch); break;
        case 3: ul_start_read_block(&the_link, batch, next_address(), words, 20); break;
        default: ul_start_get(&the_link, batch, &robot.far.signal, words);
        }
    }
    check(ul_finish(&the_link, batch));
    HAS_TO_HOLD(batch->pending == 0);
    free(words);
    free(batch);
}

static void called_back(void *context, const ul_sample *sample)
{
    HAS_TO_HOLD(sample->words != NULL);
    switch (next_byte() % 8) {
    case 0: ul_unsubscribe(&the_link, (ul_subscription *)context); break;
    case 1: ul_post(&the_link, 0x7F, 1); break;
    case 2: ul_close(&the_link); break;
    case 3: ul_poll(&the_link, 0.001); break;
    default: break;
    }
}

/* Free the memory of a subscription that has ended: the link must not access it any more. */
static void let_go(ul_subscription *one)
{
    free((void *)(uintptr_t)one->addresses);
    free(one->storage);
    memset(one, 0, sizeof *one);
}

static void begin_subscription(ul_subscription *one)
{
    check(ul_unsubscribe(&the_link, one));
    let_go(one);
    unsigned flags = next_byte();
    size_t count = next_count(), samples = next_byte() % 6;
    uint32_t *addresses = (uint32_t *)lent(count * sizeof *addresses);
    for (size_t index = 0; index < count; index++) addresses[index] = (uint32_t)index;
    one->addresses = addresses;
    one->count = (unsigned)count;
    one->storage_words = UL_STORAGE(samples, count);
    one->storage = (uint64_t *)lent(one->storage_words * sizeof *one->storage);
    one->timestamps = flags & 1;
    one->on_change = flags & 2;
    one->trigger = flags & 4;
    one->immediate = flags & 8;
    if (flags & 16) one->rate_hz = (double)(int)(next_byte() - 4) * 10;
    if (flags & 32) one->divisor = (unsigned)next_number(3);
    if (flags & 64) one->group = next_byte();
    if (flags & 128) one->callback = called_back;
    one->context = one;
    check(ul_subscribe(&the_link, one));
}

static void take_sample(ul_subscription *one)
{
    ul_sample sample;
    ul_status status = ul_next(&the_link, one, &sample, 0.001 * next_byte());
    uint64_t sum = 0;
    check(status);
    for (unsigned index = 0; status == UL_OK && index < one->count; index++) sum += sample.words[index];
    HAS_TO_HOLD(status != UL_OK || sum + 1 != sum);
}

static void call_subscription(unsigned choice)
{
    ul_subscription *one = &subscriptions[next_byte() % SUBSCRIPTIONS];
    switch (choice % 6) {
    case 0: begin_subscription(one); break;
    case 1: check(ul_unsubscribe(&the_link, one)); break;
    case 2: check(ul_publish(&the_link, one)); break;
    case 3: check(ul_await(&the_link, one, next_byte() % 8, 0.001 * next_byte())); break;
    case 4: check(ul_poll(&the_link, 0.001 * next_byte())); break;
    default: take_sample(one);
    }
}

/* Return any double, including NaN and infinity. */
static double next_real(void)
{
    uint64_t bits = next_number(8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return next_byte() & 1 ? value : (double)(int)next_byte();
}

static void call_signals(unsigned choice)
{
    double real;
    int64_t whole;
    uint64_t natural;
    bool truth;
    robot_mode mode;
    robot_state state = {0};
    ul_network_state network;
    switch (choice % 16) {
    case 0: check(ul_get_real(&the_link, &robot.angle, &real)); break;
    case 1: check(ul_set_real(&the_link, &robot.angle, next_real())); break;
    case 2: check(ul_post_real(&the_link, &robot.arms[1].warm, next_real())); break;
    case 3: check(ul_get_signed(&the_link, &robot.far, &whole)); break;
    case 4: check(ul_set_signed(&the_link, &robot.far, (int64_t)next_number(8))); break;
    case 5: check(ul_set_unsigned(&the_link, &robot.arms[0].count, next_number(8))); break;
    case 6: check(ul_post_unsigned(&the_link, &robot.arms[0].count, next_word())); break;
    case 7: check(ul_get_unsigned(&the_link, &robot.arms[1].count, &natural)); break;
    case 8: check(ul_set_bool(&the_link, &robot.enable, next_byte() & 1)); break;
    case 9: check(ul_get_bool(&the_link, &robot.enable, &truth)); break;
    case 10: check(robot_mode_set(&the_link, &robot.mode, (robot_mode)next_byte())); break;
    case 11: check(robot_mode_get(&the_link, &robot.mode, &mode)); break;
    case 12: check(robot_state_read(&the_link, &state)); break;
    case 13: check(robot_networks_use(&the_link, &networks, choice & 16 ? 0xF0 : UL_NOT_GIVEN, choice & 32 ? 0xF1 : UL_NOT_GIVEN)); break;
    case 14: check(ul_network_get_state(&the_link, &networks.networks[0], &network)); break;
    default: check(ul_post_signed(&the_link, &robot.joint, (int64_t)next_word())); break;
    }
}

static void call_feed(unsigned choice)
{
    robot_state state;
    ul_sample sample;
    if (choice & 1) {
        check(ul_unsubscribe(&the_link, &feed.base));
        memset(&feed, 0, sizeof feed);
        check(robot_state_subscribe(&the_link, &feed));
    } else if (feed.base.storage != NULL) {
        check(robot_state_next(&the_link, &feed, &state, &sample, 0.001 * next_byte()));
    }
}

static void open_again(void)
{
    check(ul_close(&the_link));
    HAS_TO_HOLD(!is_open);
    ul_transport medium = open_medium();
    check(ul_open(&the_link, &medium, node, 0.01 * next_byte()));
    HAS_TO_HOLD(the_link.open == is_open);
}

static void call(void)
{
    unsigned choice = next_byte();
    switch (choice % 16) {
    case 0: case 1: case 2: call_words(choice >> 4); break;
    case 3: call_block(choice >> 4); break;
    case 4: call_many(choice & 16); break;
    case 5: call_batch(); break;
    case 6: case 7: call_subscription(choice >> 4); break;
    case 8: case 9: call_signals(next_byte()); break;
    case 10: call_feed(choice >> 4); break;
    case 11: check(ul_fence(&the_link)); break;
    case 12: (void)ul_take_posts(&the_link); break;
    case 13: check(ul_send_immediate(&the_link, next_byte())); break;
    case 14: check(robot_check_map(&the_link)); break;
    default:
        if (choice & 16) check(ul_close(&the_link));
        else open_again();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    begin_input(data, size);
    memset(&the_link, 0, sizeof the_link);
    memset(&feed, 0, sizeof feed);
    open_again();
    for (unsigned calls = 0; input_left > 0 && calls < MOST_CALLS; calls++) call();
    check(ul_close(&the_link));
    HAS_TO_HOLD(!is_open);
    for (unsigned index = 0; index < SUBSCRIPTIONS; index++) let_go(&subscriptions[index]);
    return 0;
}
