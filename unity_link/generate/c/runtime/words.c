/* Words: the functions for programs that read and write words. ----------------------------------------------------- */

ul_status ul_finish(ul_link *link, ul_batch *batch)
{
    commit_changes(link, batch);
    while (batch->pending > 0 && !link->gone) turn(link, now_of(link) + LONGEST_TIMEOUT);
    flush(link);
    return batch->status == UL_OK ? UL_OK : fail_batch(link, batch);
}

void ul_start_read(ul_link *link, ul_batch *batch, uint32_t address, uint64_t *word)
{
    start(link, batch, (ul_request){.command = "r", .address = address, .target = word});
}

void ul_start_write(ul_link *link, ul_batch *batch, uint32_t address, uint64_t word)
{
    start(link, batch, (ul_request){.command = "w", .address = address, .word = word});
}

void ul_start_write_masked(ul_link *link, ul_batch *batch, uint32_t address, uint64_t word, uint64_t mask,
                           uint64_t *before)
{
    start(link, batch, (ul_request){.command = "wk", .address = address, .word = word, .mask = mask, .target = before});
}

/* Send the requests of a block, each at most as long as the gateway allows; `step` is 0 for a queue. */
static void start_block(ul_link *link, ul_batch *batch, ul_request request, size_t count, uint32_t step)
{
    const char *name = shape_of(request.command)->name;
    size_t most = link->open ? link->block_words : count;
    if (count == 0) refuse(batch, UL_BAD_ARGUMENT, name, request.address, "at least one word is needed");
    if (link->open && step * (uint64_t)(count - 1) > ones(link->info.address_bits) - request.address) {
        refuse(batch, UL_BAD_ARGUMENT, name, request.address, "it would pass the gateway's last address");
        return;
    }
    /* Check all words first: `start` checks only those of its own request, after earlier requests were sent. */
    for (size_t index = 0; link->open && request.source != NULL && index < count; index++) {
        if (request.source[index] <= ones(link->info.data_bits)) continue;
        refuse(batch, UL_BAD_ARGUMENT, name, request.address, TOO_WIDE);
        return;
    }
    for (size_t rest = count; rest > 0; rest -= request.count) {
        request.count = (unsigned)(rest < most ? rest : most);
        start(link, batch, request);
        request.address += step * request.count;
        if (request.source != NULL) request.source += request.count;
        if (request.target != NULL) request.target += request.count;
    }
}

void ul_start_read_block(ul_link *link, ul_batch *batch, uint32_t address, uint64_t *words, size_t count)
{
    start_block(link, batch, (ul_request){.command = "rm", .address = address, .target = words}, count, 1);
}

void ul_start_write_block(ul_link *link, ul_batch *batch, uint32_t address, const uint64_t *words, size_t count)
{
    start_block(link, batch, (ul_request){.command = "wm", .address = address, .source = words}, count, 1);
}

void ul_start_read_queue(ul_link *link, ul_batch *batch, uint32_t address, uint64_t *words, size_t count)
{
    start_block(link, batch, (ul_request){.command = "rq", .address = address, .target = words}, count, 0);
}

void ul_start_write_queue(ul_link *link, ul_batch *batch, uint32_t address, const uint64_t *words, size_t count)
{
    start_block(link, batch, (ul_request){.command = "wq", .address = address, .source = words}, count, 0);
}

void ul_start_fence(ul_link *link, ul_batch *batch)
{
    start(link, batch, (ul_request){.command = "h"});
}

ul_status ul_read(ul_link *link, uint32_t address, uint64_t *word)
{
    ul_batch batch = UL_BATCH;
    ul_start_read(link, &batch, address, word);
    return ul_finish(link, &batch);
}

ul_status ul_write(ul_link *link, uint32_t address, uint64_t word)
{
    ul_batch batch = UL_BATCH;
    ul_start_write(link, &batch, address, word);
    return ul_finish(link, &batch);
}

ul_status ul_write_masked(ul_link *link, uint32_t address, uint64_t word, uint64_t mask, uint64_t *before)
{
    ul_batch batch = UL_BATCH;
    ul_start_write_masked(link, &batch, address, word, mask, before);
    return ul_finish(link, &batch);
}

ul_status ul_read_block(ul_link *link, uint32_t address, uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    ul_start_read_block(link, &batch, address, words, count);
    return ul_finish(link, &batch);
}

ul_status ul_write_block(ul_link *link, uint32_t address, const uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    ul_start_write_block(link, &batch, address, words, count);
    return ul_finish(link, &batch);
}

ul_status ul_read_queue(ul_link *link, uint32_t address, uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    ul_start_read_queue(link, &batch, address, words, count);
    return ul_finish(link, &batch);
}

ul_status ul_write_queue(ul_link *link, uint32_t address, const uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    ul_start_write_queue(link, &batch, address, words, count);
    return ul_finish(link, &batch);
}

ul_status ul_read_many(ul_link *link, const uint32_t *addresses, uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    for (size_t index = 0; index < count; index++) ul_start_read(link, &batch, addresses[index], &words[index]);
    return ul_finish(link, &batch);
}

ul_status ul_write_many(ul_link *link, const uint32_t *addresses, const uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    for (size_t index = 0; index < count; index++) ul_start_write(link, &batch, addresses[index], words[index]);
    return ul_finish(link, &batch);
}

/* Execute a request with its number in `address`, or without a number, and wait for its answer. */
static ul_status ask_for(ul_link *link, ul_request request)
{
    ul_batch batch = UL_BATCH;
    start(link, &batch, request);
    return ul_finish(link, &batch);
}

static ul_status post(ul_link *link, const ul_signal *signal, uint32_t address, uint64_t word)
{
    /* On a half-duplex medium each request needs an answer, which ends its slot, so send an answered write there. */
    bool posted = !(link->info.features & UL_FEATURE_HALF_DUPLEX), was_lost = !link->open || link->gone;
    ul_request request = {.posted = posted, .address = address, .word = word, .signal = signal};
    put_text(request.command, posted ? "ws" : "w");
    const char *fault = link->open ? fault_of(link, &request) : NULL;
    if (fault != NULL) return fail_at(link, UL_BAD_ARGUMENT, "posted write", address, fault);
    start(link, &link->posts, request);
    flush(link);
    if (link->open && !link->gone) return UL_OK;
    return fail_at(link, was_lost ? UL_LOST_NOT_EXECUTED : UL_LOST, "posted write", address, NULL);
}

ul_status ul_post(ul_link *link, uint32_t address, uint64_t word)
{
    return post(link, NULL, address, word);
}

ul_batch ul_take_posts(ul_link *link)
{
    ul_batch posts = link->posts;
    link->posts = UL_BATCH;
    return posts;
}

/* The first error of the posted writes since the last call, or otherwise `status`. */
static ul_status report_posts(ul_link *link, ul_status status)
{
    ul_batch posts = ul_take_posts(link);
    return posts.status == UL_OK ? status : fail_batch(link, &posts);
}

ul_status ul_fence(ul_link *link)
{
    return report_posts(link, ask_for(link, (ul_request){.command = "h"}));
}

ul_status ul_close(ul_link *link)
{
    if (!link->open) return UL_OK;
    bool idle = link->gone || in_flight(link) == 0;
    ul_status status = idle ? report_posts(link, UL_OK) : ul_fence(link);
    shut(link);
    return status;
}

ul_status ul_send_immediate(ul_link *link, unsigned mode)
{
    return ask_for(link, (ul_request){.command = "i", .address = mode});
}
