/* Double-buffered memories (docs/how-to/windows.md, TosNet). ----------------------------------------------------------
 *
 * Writes go into one buffer until a commit. After the commit, writes go into the other buffer, which lacks the words
 * that were written last. Therefore a network stores all words that were ever written, and each commit writes all of
 * them.
 */

enum { COMMIT_WRITE = 1, COMMIT_READ = 2, LOST_CYCLES = 1000 };

static const char NOT_COMMITTED[] = "TosNet does not change its buffers: is the network online?";

static ul_status settle_network(ul_link *link, ul_network *network, unsigned which)
{
    for (unsigned tries = 0; tries < LOST_CYCLES && !network->settled; tries++) {
        uint64_t control;
        ul_status status = ul_read(link, (uint32_t)network->ctrl, &control);
        if (status != UL_OK) return status;
        network->settled = !(control & which);
    }
    if (network->settled) return UL_OK;
    return fail_at(link, UL_NOT_COMMITTED, "CTRL", (uint32_t)network->ctrl, NOT_COMMITTED);
}

/* The network that contains a word, and the word's index in it; NULL if no network contains it. */
static ul_network *network_of(const ul_link *link, uint32_t address, unsigned *place)
{
    for (ul_network *network = link->networks; network != NULL; network = network->next)
        for (*place = 0; *place < network->count; ++*place)
            if (network->words[*place].address == address) return network->ctrl < 0 ? NULL : network;
    return NULL;
}

/* Store bits of a word for the next commit, by `ul_finish`. False if no network contains the address. */
static bool start_shared(ul_link *link, ul_batch *batch, const char *path, uint32_t address, uint64_t word, uint64_t mask)
{
    unsigned place;
    ul_network *network = network_of(link, address, &place);
    if (network == NULL) return false;
    ul_status status = link->open ? settle_network(link, network, COMMIT_WRITE) : UL_LOST_NOT_EXECUTED;
    if (status != UL_OK) {
        refuse(batch, status, path, address, status == UL_NOT_COMMITTED ? NOT_COMMITTED : NULL);
        return true;
    }
    ul_network_word *kept = &network->words[place];
    kept->word = (kept->word & ~mask) | (word & mask);
    kept->written = true;
    network->changed = batch->commits = true;
    return true;
}

static void commit(ul_link *link, ul_batch *batch, ul_network *network)
{
    ul_status status = settle_network(link, network, COMMIT_WRITE);
    if (status != UL_OK) {
        refuse(batch, status, "CTRL", (uint32_t)network->ctrl, status == UL_NOT_COMMITTED ? NOT_COMMITTED : NULL);
        return;
    }
    network->changed = network->settled = false;
    for (unsigned index = 0; index < network->count; index++) {
        const ul_network_word *kept = &network->words[index];
        if (kept->written) ul_start_write(link, batch, kept->address, kept->word);
    }
    ul_start_write(link, batch, (uint32_t)network->ctrl, COMMIT_WRITE);
}

static void commit_changes(ul_link *link, ul_batch *batch)
{
    if (!batch->commits) return;
    batch->commits = false;
    for (ul_network *network = link->networks; network != NULL; network = network->next)
        if (network->changed) commit(link, batch, network);
}

ul_status ul_use_network(ul_link *link, ul_network *network)
{
    const ul_network *other = link->networks;
    if (!link->open) return fail(link, UL_LOST_NOT_EXECUTED, "network", NULL);
    if (network->ctrl > (int64_t)ones(link->info.address_bits) || network->comm > (int64_t)ones(link->info.address_bits))
        return fail(link, UL_BAD_ARGUMENT, "network", "CTRL or COMM is beyond the gateway's last address");
    while (other != NULL && other != network) other = other->next;
    if (other != NULL) return UL_OK;
    network->changed = network->settled = false;
    for (unsigned index = 0; index < network->count; index++) {
        /* Copy the words that were written through another structure of the same network. */
        ul_network_word *kept = &network->words[index];
        unsigned place;
        const ul_network *before = network_of(link, kept->address, &place);
        bool is_same = before != NULL && before->ctrl == network->ctrl;
        kept->written = is_same && before->words[place].written;
        kept->word = is_same ? before->words[place].word : 0;
    }
    network->next = link->networks;
    link->networks = network;
    return UL_OK;
}

ul_status ul_commit_write(ul_link *link, ul_network *network)
{
    ul_batch batch = UL_BATCH;
    if (network->ctrl < 0) return fail(link, UL_BAD_ARGUMENT, "commit", "CTRL was not given");
    commit(link, &batch, network);
    ul_status status = ul_finish(link, &batch);
    return status == UL_OK ? settle_network(link, network, COMMIT_WRITE) : status;
}

ul_status ul_commit_read(ul_link *link, ul_network *network)
{
    if (network->ctrl < 0) return fail(link, UL_BAD_ARGUMENT, "commit", "CTRL was not given");
    ul_status status = settle_network(link, network, COMMIT_WRITE);
    if (status == UL_OK) status = ul_write(link, (uint32_t)network->ctrl, COMMIT_READ);
    network->settled = false;
    return status == UL_OK ? settle_network(link, network, COMMIT_READ) : status;
}

ul_status ul_network_get_state(ul_link *link, const ul_network *network, ul_network_state *state)
{
    uint64_t words[4];
    if (network->comm < 0) return fail(link, UL_BAD_ARGUMENT, "state", "COMM was not given");
    ul_status status = ul_read_block(link, (uint32_t)network->comm, words, 4);
    if (status != UL_OK) return status;
    *state = (ul_network_state){
        .online = words[0] & 1, .is_master = words[0] >> 1 & 1, .packet_error = words[0] >> 2 & 1,
        .system_halt = words[0] >> 3 & 1, .resets = words[1], .packets = words[2], .errors = words[3],
    };
    return UL_OK;
}

ul_status ul_write_module(ul_link *link, uint32_t address, const uint64_t *words, size_t count)
{
    ul_batch batch = UL_BATCH;
    unsigned place;
    bool is_shared = false;
    for (size_t index = 0; index < count; index++)
        if (network_of(link, address + (uint32_t)index, &place) != NULL) is_shared = true;
    if (!is_shared) return ul_write_block(link, address, words, count);
    for (size_t index = 0; index < count; index++) {
        uint32_t at = address + (uint32_t)index;
        if (!start_shared(link, &batch, "word", at, words[index], ones(link->info.data_bits)))
            ul_start_write(link, &batch, at, words[index]);
    }
    return ul_finish(link, &batch);
}
