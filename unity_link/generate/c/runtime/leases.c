/* Leases (docs/how-to/stop-safely.md). --------------------------------------------------------------------------------
 *
 * A word that arms or kicks names the end of the lease as an instant of the gateway's clock, so one that waits on its way
 * prolongs nothing. The clock is read first, and the end counts from that.
 */

/* Above the token stands what the owner wants on silence. */
enum { LEASE_TIME_BITS = 40, LEASE_TOKEN_BITS = 23 };

static ul_status fail_lease(ul_link *link, const ul_lease *lease, const char *reason)
{
    return fail_at(link, UL_BUS_ERROR, lease->armed->signal.path, lease->armed->signal.address, reason);
}

/* Read the clock, and whose the lease is: in one round trip. */
static ul_status look_at_lease(ul_link *link, const ul_lease *lease, uint64_t *clock, bool *armed, uint64_t *arms)
{
    uint64_t clock_words[UL_SIGNAL_WORDS], armed_words[UL_SIGNAL_WORDS], arms_words[UL_SIGNAL_WORDS];
    ul_batch batch = UL_BATCH;
    ul_start_get(link, &batch, &lease->clock->signal, clock_words);
    ul_start_get(link, &batch, &lease->armed->signal, armed_words);
    ul_start_get(link, &batch, &lease->arms->signal, arms_words);
    ul_status status = ul_finish(link, &batch);
    if (status != UL_OK) return status;
    *clock = ul_decode_unsigned(&lease->clock->signal, clock_words);
    /* They stand in one word; a lease that is finishing takes nothing from anybody. */
    *armed = ul_decode_unsigned(&lease->armed->signal, armed_words) != 0 &&
             ul_decode_unsigned(&lease->finishing->signal, armed_words) == 0;
    *arms = ul_decode_unsigned(&lease->arms->signal, arms_words);
    return UL_OK;
}

static uint64_t lease_word(const ul_link *link, const ul_lease *lease, uint64_t clock)
{
    uint64_t end = clock + (uint64_t)(lease->seconds * (double)link->info.clock_hz);
    return lease->token << LEASE_TIME_BITS | (end & ((UINT64_C(1) << LEASE_TIME_BITS) - 1));
}

ul_status ul_lease_arm(ul_link *link, ul_lease *lease, double seconds)
{
    uint64_t clock, before, after;
    bool armed;
    if (!(seconds > 0 && seconds < 3600)) return fail_lease(link, lease, "a lease lasts more than 0 s, and less than 3600");
    ul_status status = look_at_lease(link, lease, &clock, &armed, &before);
    if (status != UL_OK) return status;
    if (armed) return fail_lease(link, lease, "it cannot be armed: another program has armed it");
    lease->seconds = seconds;
    /* Another one at each instant of three seconds and more; it keeps programs apart, and is no secret. */
    lease->token = (clock * UINT64_C(0x9E3779B97F4A7C15)) >> (64 - LEASE_TOKEN_BITS);
    if (lease->finishes) lease->token |= UINT64_C(1) << LEASE_TOKEN_BITS;
    status = ul_set_unsigned(link, lease->arm, lease_word(link, lease, clock));
    if (status != UL_OK) return status;
    status = look_at_lease(link, lease, &clock, &armed, &after);
    if (status != UL_OK) return status;
    lease->count = after;
    lease->session = link->session;
    if (armed && after == ((before + 1) & 0xFFFF)) return UL_OK;
    return fail_lease(link, lease, armed ? "it cannot be armed: another program has armed it"
                         : lease->finishes
                             ? "it was not armed: its e-stop is open, the line takes longer than the lease, that is longer "
                               "than TIMEOUT of the spec, the spec has no FINISH, or that of another program is finishing"
                             : "it was not armed: its e-stop is open, the line takes longer than the lease, that is longer "
                               "than TIMEOUT of the spec, or that of another program is finishing");
}

ul_status ul_lease_kick(ul_link *link, ul_lease *lease)
{
    uint64_t clock, arms;
    bool armed;
    /* A reset begins the count of leases again, so the count of another program's may be the same. */
    if (link->open && lease->session != link->session) return fail_lease(link, lease, "it was armed in another session: arm it again");
    ul_status status = look_at_lease(link, lease, &clock, &armed, &arms);
    if (status != UL_OK) return status;
    if (!armed || arms != lease->count) return fail_lease(link, lease, "it is not armed any more: what it guards is safe, or finishes");
    return ul_set_unsigned(link, lease->kick, lease_word(link, lease, clock));
}

ul_status ul_lease_disarm(ul_link *link, const ul_lease *lease)
{
    return ul_set_unsigned(link, lease->disarm, 1);
}
