/* Signals: conversion of words to values and back. --------------------------------------------------------------------
 *
 * The *raw* value of a signal is its bits as an unsigned number. Values are rounded to the nearest number, ties to
 * even.
 */

static const double TWO_TO_63 = 9223372036854775808.0;

unsigned ul_words_of(const ul_signal *signal)
{
    unsigned bits = (unsigned)signal->lowest_bit + signal->width;
    return (bits + signal->word_bits - 1) / signal->word_bits;
}

static uint64_t raw_of(const ul_signal *signal, const uint64_t *words)
{
    uint64_t raw = words[0] >> signal->lowest_bit;
    for (unsigned index = 1; index < ul_words_of(signal); index++)
        raw |= words[index] << (index * signal->word_bits - signal->lowest_bit);
    return raw & ones(signal->width);
}

static void put_raw(const ul_signal *signal, uint64_t raw, uint64_t *words)
{
    words[0] = raw << signal->lowest_bit & ones(signal->word_bits);
    for (unsigned index = 1; index < ul_words_of(signal); index++)
        words[index] = raw >> (index * signal->word_bits - signal->lowest_bit) & ones(signal->word_bits);
}

/* IEEE 754 numbers and their bits. */

static double double_of(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint64_t bits_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static double decode_half(uint64_t raw)
{
    uint64_t sign = raw >> 15 << 63, exponent = raw >> 10 & 31, fraction = raw & 1023;
    if (exponent == 31) return double_of(sign | (uint64_t)2047 << 52 | fraction << 42);
    if (exponent == 0) return (sign ? -1 : 1) * (double)fraction * 0x1p-24;
    return double_of(sign | (exponent + 1023 - 15) << 52 | fraction << 42);
}

static double decode_float(const ul_signal *signal, uint64_t raw)
{
    if (signal->width == 64) return double_of(raw);
    if (signal->width == 16) return decode_half(raw);
    uint32_t bits = (uint32_t)raw;
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

/* Shift a number to the right by `bits`, and round it to the nearest number, ties to even. */
static uint64_t shift_nearest(uint64_t number, unsigned bits)
{
    uint64_t rest = number & ones(bits), middle = (uint64_t)1 << (bits - 1);
    number >>= bits;
    return number + (rest > middle || (rest == middle && number & 1));
}

static bool encode_half(double value, uint64_t *raw)
{
    uint64_t bits = bits_of(value), sign = bits >> 63 << 15, fraction = bits & ones(52);
    int exponent = (int)(bits >> 52 & 2047) - 1023;
    double magnitude = value < 0 ? -value : value;
    if (value != value) *raw = sign | 0x7E00;
    else if (exponent == 1024) *raw = sign | 0x7C00;
    else if (magnitude >= 65520) return false;
    else if (exponent >= -14) *raw = sign | (((uint64_t)(exponent + 15) << 10) + shift_nearest(fraction, 42));
    else if (exponent < -25) *raw = sign;
    else *raw = sign | shift_nearest(fraction | (uint64_t)1 << 52, (unsigned)(28 - exponent));
    return true;
}

/* Convert a number to the bits of a float; false if the number is too large for the width. */
static bool encode_float(const ul_signal *signal, double value, uint64_t *raw)
{
    if (signal->width == 16) return encode_half(value, raw);
    if (signal->width == 64) {
        *raw = bits_of(value);
        return true;
    }
    bool infinite = value - value != 0 && value == value;
    if (!infinite && (value >= 0x1.ffffffp127 || value <= -0x1.ffffffp127)) return false;
    float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    *raw = bits;
    return true;
}

/* Limits. Integers are compared as integers, because a double cannot represent all 64-bit numbers. */

static double limit_of(const ul_signal *signal, ul_limit limit)
{
    if (!(signal->properties & UL_WHOLE)) return limit.real;
    return signal->kind == UL_SIGNED ? (double)limit.whole : (double)limit.natural;
}

static bool is_limited(const ul_signal *signal)
{
    return signal->properties & UL_LIMITED;
}

uint64_t ul_decode_unsigned(const ul_signal *signal, const uint64_t *words)
{
    return raw_of(signal, words);
}

int64_t ul_decode_signed(const ul_signal *signal, const uint64_t *words)
{
    uint64_t raw = raw_of(signal, words), sign = (uint64_t)1 << (signal->width - 1);
    /* Extend the sign bit, then convert two's complement without an overflow in either type. */
    raw = (raw ^ sign) - sign;
    return raw >> 63 ? -(int64_t)~raw - 1 : (int64_t)raw;
}

double ul_decode_real(const ul_signal *signal, const uint64_t *words)
{
    if (signal->kind == UL_FLOAT) return decode_float(signal, raw_of(signal, words));
    double number = signal->kind == UL_SIGNED ? (double)ul_decode_signed(signal, words) : (double)raw_of(signal, words);
    return number * signal->step + signal->offset;
}

ul_status ul_encode_unsigned(const ul_signal *signal, uint64_t value, uint64_t *words)
{
    if (value > ones(signal->width)) return UL_BAD_ARGUMENT;
    if (is_limited(signal) && (value < signal->minimum.natural || value > signal->maximum.natural))
        return UL_BAD_ARGUMENT;
    put_raw(signal, value, words);
    return UL_OK;
}

ul_status ul_encode_signed(const ul_signal *signal, int64_t value, uint64_t *words)
{
    int64_t most = (int64_t)ones(signal->width - 1u);
    if (value > most || value < -most - 1) return UL_BAD_ARGUMENT;
    if (is_limited(signal) && (value < signal->minimum.whole || value > signal->maximum.whole)) return UL_BAD_ARGUMENT;
    put_raw(signal, (uint64_t)value & ones(signal->width), words);
    return UL_OK;
}

/* The nearest integer, ties to even; `value` must be in the range of int64_t. */
static int64_t nearest(double value)
{
    int64_t whole = (int64_t)value;
    double rest = value - (double)whole;
    if (rest > 0.5 || (rest == 0.5 && whole & 1)) whole++;
    if (rest < -0.5 || (rest == -0.5 && whole & 1)) whole--;
    return whole;
}

ul_status ul_encode_real(const ul_signal *signal, double value, uint64_t *words)
{
    double low = limit_of(signal, signal->minimum), high = limit_of(signal, signal->maximum);
    /* The comparison is false for NaN. */
    if (is_limited(signal) && !(low <= value && value <= high)) return UL_BAD_ARGUMENT;
    uint64_t raw;
    if (signal->kind == UL_FLOAT) {
        if (!encode_float(signal, value, &raw)) return UL_BAD_ARGUMENT;
    } else {
        double steps = (value - signal->offset) / signal->step;
        if (!(steps > -TWO_TO_63 && steps < TWO_TO_63)) return UL_BAD_ARGUMENT;
        int64_t number = nearest(steps), least = 0, most = (int64_t)(ones(signal->width) >> 1);
        if (signal->kind == UL_SIGNED) least = -most - 1;
        else most = (int64_t)ones(signal->width < 63 ? signal->width : 63);
        if (number < least || number > most) return UL_BAD_ARGUMENT;
        raw = (uint64_t)number & ones(signal->width);
    }
    put_raw(signal, raw, words);
    return UL_OK;
}

/* Over a link */

/* The range of a signal: its limits in the spec, or otherwise the values that its bits can represent. */
static void range_of(const ul_signal *signal, ul_limit *low, ul_limit *high)
{
    uint64_t most = ones(signal->kind == UL_SIGNED ? signal->width - 1u : signal->width);
    *low = signal->minimum;
    *high = signal->maximum;
    if (is_limited(signal)) return;
    if (signal->kind == UL_FLOAT) {
        high->real = signal->width == 16 ? 65504 : 0x1.fffffep127;
        low->real = -high->real;
    } else if (!(signal->properties & UL_WHOLE)) {
        double first = signal->offset, last = signal->offset + (double)most * signal->step;
        if (signal->kind == UL_SIGNED) first -= ((double)most + 1) * signal->step;
        low->real = first < last ? first : last;
        high->real = first < last ? last : first;
    } else if (signal->kind == UL_SIGNED) {
        high->whole = (int64_t)most;
        low->whole = -high->whole - 1;
    } else {
        high->natural = most;
        low->natural = 0;
    }
}

enum { NUMBER_SIZE = 32 };

static void show_real(char *number, double value)
{
    snprintf(number, NUMBER_SIZE, "%.12g", value);
}

static void show_signed(char *number, int64_t value)
{
    snprintf(number, NUMBER_SIZE, "%lld", (long long)value);
}

static void show_unsigned(char *number, uint64_t value)
{
    snprintf(number, NUMBER_SIZE, "%llu", (unsigned long long)value);
}

static void show_limit(char *number, const ul_signal *signal, ul_limit limit)
{
    if (!(signal->properties & UL_WHOLE)) show_real(number, limit.real);
    else if (signal->kind == UL_SIGNED) show_signed(number, limit.whole);
    else show_unsigned(number, limit.natural);
}

static ul_status refuse_value(ul_link *link, const ul_signal *signal, const char *value)
{
    ul_limit low, high;
    char first[NUMBER_SIZE], last[NUMBER_SIZE], reason[128];
    range_of(signal, &low, &high);
    show_limit(first, signal, low);
    show_limit(last, signal, high);
    snprintf(reason, sizeof reason, "%s is outside of %s to %s%s%s", value, first, last,
             *signal->unit == '\0' ? "" : " ", signal->unit);
    return fail(link, UL_BAD_ARGUMENT, signal->path, reason);
}

ul_status ul_refuse_unsigned(ul_link *link, const ul_signal *signal, uint64_t value)
{
    char number[NUMBER_SIZE];
    show_unsigned(number, value);
    return refuse_value(link, signal, number);
}

ul_status ul_refuse_signed(ul_link *link, const ul_signal *signal, int64_t value)
{
    char number[NUMBER_SIZE];
    show_signed(number, value);
    return refuse_value(link, signal, number);
}

ul_status ul_refuse_real(ul_link *link, const ul_signal *signal, double value)
{
    char number[NUMBER_SIZE];
    show_real(number, value);
    return refuse_value(link, signal, number);
}

/* Record an error in the batch if an access to a signal is not possible at all; true if so. */
static bool cannot(const ul_link *link, ul_batch *batch, const ul_signal *signal, unsigned needed)
{
    if (!(signal->properties & needed)) {
        const char *reason = needed == UL_READABLE ? "it can only be written" : "it can only be read";
        refuse(batch, UL_BAD_ARGUMENT, signal->path, signal->address, reason);
        return true;
    }
    if (link->open && needed == UL_WRITABLE && signal->properties & UL_SHARED && link->networks == NULL) {
        refuse(batch, UL_BAD_ARGUMENT, signal->path, signal->address, "the network around it is not in use yet");
        return true;
    }
    if (!link->open) return false;
    if (signal->word_bits != link->info.data_bits) {
        refuse(batch, UL_UNSUPPORTED, signal->path, signal->address, "the gateway's words are not as wide as the spec's");
        return true;
    }
    if (signal->map == 0 || !is_of_another_map(link, signal->map)) return false;
    refuse(batch, UL_UNSUPPORTED, signal->path, signal->address, "the gateway was built from another spec than this");
    return true;
}

void ul_start_get(ul_link *link, ul_batch *batch, const ul_signal *signal, uint64_t *words)
{
    unsigned count = ul_words_of(signal);
    if (cannot(link, batch, signal, UL_READABLE)) return;
    if (signal->properties & UL_CLEARED && link->open && !(link->info.features & UL_FEATURE_QUEUE_COMMANDS)) {
        refuse(batch, UL_UNSUPPORTED, signal->path, signal->address,
               "each read clears it, which takes the queue commands that the gateway was built without");
        return;
    }
    bool is_taken = signal->properties & (UL_QUEUE | UL_CLEARED);
    ul_request request = {.command = "r", .address = signal->address, .target = words, .signal = signal};
    if (is_taken || count > 1) put_text(request.command, is_taken ? "rq" : "rm");
    if (is_taken || count > 1) start_block(link, batch, request, is_taken ? 1 : count, !is_taken);
    else start(link, batch, request);
}

/* Store the words of a signal for the next commit; false if the signal is in no network. */
static bool set_shared(ul_link *link, ul_batch *batch, const ul_signal *signal, const uint64_t *words)
{
    /* A field has only one word. */
    bool is_field = signal->properties & UL_FIELD;
    uint64_t mask = is_field ? ones(signal->width) << signal->lowest_bit : ones(signal->word_bits);
    for (unsigned index = 0; index < ul_words_of(signal); index++)
        if (!start_shared(link, batch, signal->path, signal->address + index, words[index], mask)) return false;
    return true;
}

void ul_start_set(ul_link *link, ul_batch *batch, const ul_signal *signal, const uint64_t *words)
{
    unsigned count = ul_words_of(signal);
    bool is_field = signal->properties & UL_FIELD;
    ul_request request = {.command = "w", .address = signal->address, .word = words[0], .signal = signal};
    if (cannot(link, batch, signal, UL_WRITABLE)) return;
    if (!(signal->properties & UL_QUEUE) && set_shared(link, batch, signal, words)) return;
    if (is_field) {
        put_text(request.command, "wk");
        request.mask = ones(signal->width) << signal->lowest_bit;
    } else if (count > 1) {
        put_text(request.command, "wm");
        request.source = words;
        start_block(link, batch, request, count, 1);
        return;
    }
    start(link, batch, request);
}

static ul_status get_words(ul_link *link, const ul_signal *signal, uint64_t *words)
{
    ul_batch batch = UL_BATCH;
    ul_start_get(link, &batch, signal, words);
    return ul_finish(link, &batch);
}

static ul_status set_words(ul_link *link, const ul_signal *signal, const uint64_t *words)
{
    ul_batch batch = UL_BATCH;
    ul_start_set(link, &batch, signal, words);
    return ul_finish(link, &batch);
}

ul_status ul_post_words(ul_link *link, const ul_signal *signal, const uint64_t *words)
{
    ul_batch batch = UL_BATCH;
    ul_status status = UL_OK;
    if (cannot(link, &batch, signal, UL_WRITABLE)) return ul_finish(link, &batch);
    /* A commit needs an answer, so wait for it. */
    if (!(signal->properties & UL_QUEUE) && set_shared(link, &batch, signal, words)) return ul_finish(link, &batch);
    if (signal->properties & UL_FIELD) {
        ul_start_set(link, &link->posts, signal, words);
        flush(link);
        return link->gone ? fail_at(link, UL_LOST_NOT_EXECUTED, signal->path, signal->address, NULL) : UL_OK;
    }
    for (unsigned index = 0; index < ul_words_of(signal) && status == UL_OK; index++)
        status = post(link, signal, signal->address + index, words[index]);
    return status;
}

ul_status ul_get_bool(ul_link *link, const ul_bool *signal, bool *value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    ul_status status = get_words(link, &signal->signal, words);
    if (status == UL_OK) *value = ul_decode_unsigned(&signal->signal, words) != 0;
    return status;
}

ul_status ul_get_unsigned(ul_link *link, const ul_unsigned *signal, uint64_t *value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    ul_status status = get_words(link, &signal->signal, words);
    if (status == UL_OK) *value = ul_decode_unsigned(&signal->signal, words);
    return status;
}

ul_status ul_get_signed(ul_link *link, const ul_signed *signal, int64_t *value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    ul_status status = get_words(link, &signal->signal, words);
    if (status == UL_OK) *value = ul_decode_signed(&signal->signal, words);
    return status;
}

ul_status ul_get_real(ul_link *link, const ul_real *signal, double *value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    ul_status status = get_words(link, &signal->signal, words);
    if (status == UL_OK) *value = ul_decode_real(&signal->signal, words);
    return status;
}

ul_status ul_set_bool(ul_link *link, const ul_bool *signal, bool value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_unsigned(&signal->signal, value, words)) return ul_refuse_unsigned(link, &signal->signal, value);
    return set_words(link, &signal->signal, words);
}

ul_status ul_set_unsigned(ul_link *link, const ul_unsigned *signal, uint64_t value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_unsigned(&signal->signal, value, words)) return ul_refuse_unsigned(link, &signal->signal, value);
    return set_words(link, &signal->signal, words);
}

ul_status ul_set_signed(ul_link *link, const ul_signed *signal, int64_t value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_signed(&signal->signal, value, words)) return ul_refuse_signed(link, &signal->signal, value);
    return set_words(link, &signal->signal, words);
}

ul_status ul_set_real(ul_link *link, const ul_real *signal, double value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_real(&signal->signal, value, words)) return ul_refuse_real(link, &signal->signal, value);
    return set_words(link, &signal->signal, words);
}

ul_status ul_post_bool(ul_link *link, const ul_bool *signal, bool value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_unsigned(&signal->signal, value, words)) return ul_refuse_unsigned(link, &signal->signal, value);
    return ul_post_words(link, &signal->signal, words);
}

ul_status ul_post_unsigned(ul_link *link, const ul_unsigned *signal, uint64_t value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_unsigned(&signal->signal, value, words)) return ul_refuse_unsigned(link, &signal->signal, value);
    return ul_post_words(link, &signal->signal, words);
}

ul_status ul_post_signed(ul_link *link, const ul_signed *signal, int64_t value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_signed(&signal->signal, value, words)) return ul_refuse_signed(link, &signal->signal, value);
    return ul_post_words(link, &signal->signal, words);
}

ul_status ul_post_real(ul_link *link, const ul_real *signal, double value)
{
    uint64_t words[UL_SIGNAL_WORDS];
    if (ul_encode_real(&signal->signal, value, words)) return ul_refuse_real(link, &signal->signal, value);
    return ul_post_words(link, &signal->signal, words);
}
