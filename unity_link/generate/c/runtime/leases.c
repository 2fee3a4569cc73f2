/* Leases (docs/how-to/stop-safely.md). --------------------------------------------------------------------------------
 *
 * A word that arms or kicks contains the end of the lease as a time of the gateway's clock, so that a delayed word does
 * not extend the lease. The clock is read first, and the end is computed from that time.
 */

/* Widths of the end and the token in a word. The bit above the token is set if the lease finishes its schedule on
 * silence. */
enum { LEASE_TIME_BITS = 40, LEASE_TOKEN_BITS = 23 };
/* Numbers of states and reasons in the map of a LEASE. */
enum { LEASE_ARMED = 1, LEASE_FAULT, LEASE_FINISHING };
enum { NEVER_ARMED, STOPPED_BY_ESTOP = 3 };

/* The values of a lease's registers. */
typedef struct lease_state {
    uint64_t clock, state, reason, arms, fault_time;
    bool estop_open;
} lease_state;

static ul_status fail_lease(ul_link *link, const ul_lease *lease, const char *reason)
{
    return fail_at(link, UL_BUS_ERROR, lease->armed->signal.path, lease->armed->signal.address, reason);
}

/* Read the registers of a lease in one round trip, with the state and the count in one bus transaction. */
static ul_status read_lease(ul_link *link, const ul_guard *guard, lease_state *is)
{
    uint64_t words[2], clock[UL_SIGNAL_WORDS], fault_time[UL_SIGNAL_WORDS];
    ul_batch batch = UL_BATCH;
    if (guard == NULL) return fail(link, UL_UNSUPPORTED, "lease", "its map is not the one of this version's LEASE");
    ul_start_get(link, &batch, guard->clock, clock);
    ul_start_read_block(link, &batch, guard->state->address, words, 2);
    ul_start_get(link, &batch, guard->fault_time, fault_time);
    ul_status status = ul_finish(link, &batch);
    if (status != UL_OK) return status;
    is->clock = ul_decode_unsigned(guard->clock, clock);
    is->state = ul_decode_unsigned(guard->state, words);
    is->reason = ul_decode_unsigned(guard->reason, words);
    is->estop_open = ul_decode_unsigned(guard->estop_open, words) != 0;
    is->arms = ul_decode_unsigned(guard->arms, words + 1);
    is->fault_time = ul_decode_unsigned(guard->fault_time, fault_time);
    return UL_OK;
}

/* Whether this program has armed a lease, which is armed or finishing, on this link. */
static bool is_own(const ul_link *link, const ul_guard *guard, const lease_state *is)
{
    for (unsigned place = 0; place < UL_LEASES; place++)
        if (link->armed[place].guard == guard && link->armed[place].count == is->arms) return true;
    return false;
}

/* Write into `why` the reason why writes under a lease are refused. */
static void show_why(const ul_link *link, const ul_guard *guard, const lease_state *is, char *why, size_t size)
{
    const char *name = guard->path;
    if (is->state == LEASE_ARMED)
        snprintf(why, size, "another program has armed %.80s, and it alone may move what that guards", name);
    else if (is->state == LEASE_FINISHING)
        snprintf(why, size, "%.80s is finishing: no kick came before its end, and what was scheduled by then runs out", name);
    else if (is->state != LEASE_FAULT)
        snprintf(why, size, "%.80s is not armed: %s", name,
                 is->reason == NEVER_ARMED ? "nobody has armed it since the reset" : "it was disarmed");
    else
        snprintf(why, size, "%.80s is not armed: %s, at %.6f s of the gateway's clock", name,
                 is->reason == STOPPED_BY_ESTOP ? "its e-stop was opened" : "no kick came before its end",
                 (double)is->fault_time / (double)link->info.clock_hz);
}

/* Read a lease, and write into `why` the reason why writes are refused. False if the lease cannot be read, or if
 * this program has armed it, so that there is another reason. */
static bool say_why(ul_link *link, const ul_guard *guard, char *why, size_t size)
{
    lease_state is;
    if (read_lease(link, guard, &is) != UL_OK) return false;
    if (is.state == LEASE_ARMED && is_own(link, guard, &is)) return false;
    show_why(link, guard, &is, why, size);
    return true;
}

static uint64_t lease_word(const ul_link *link, const ul_lease *lease, uint64_t clock)
{
    uint64_t end = clock + (uint64_t)(lease->seconds * (double)link->info.clock_hz);
    return lease->token << LEASE_TIME_BITS | (end & ((UINT64_C(1) << LEASE_TIME_BITS) - 1));
}

/* Store that this program has armed a lease, in the lease's earlier place, or in a free place, or in the oldest one. */
static void note_arming(ul_link *link, const ul_guard *guard, uint64_t count)
{
    ul_armed *place = NULL;
    for (unsigned index = 0; index < UL_LEASES && place == NULL; index++)
        if (link->armed[index].guard == guard) place = &link->armed[index];
    if (place == NULL) place = &link->armed[link->armings++ % UL_LEASES];
    *place = (ul_armed){guard, count};
}

/* The reason why a lease cannot be armed in a state; NULL if it can be armed. */
static const char *obstacle_of(const ul_link *link, const ul_guard *guard, const lease_state *is)
{
    if (is->state != LEASE_ARMED && is->state != LEASE_FINISHING)
        return is->estop_open ? "it cannot be armed: its e-stop is open" : NULL;
    if (is_own(link, guard, is)) return "it cannot be armed: this program has armed it already";
    return is->state == LEASE_ARMED ? "it cannot be armed: another program has armed it"
                                    : "it cannot be armed: that of another program is finishing";
}

ul_status ul_lease_arm(ul_link *link, ul_lease *lease, double seconds)
{
    const ul_guard *guard = lease->armed->signal.guard;
    const char *obstacle;
    lease_state before, after;
    if (!(seconds > 0 && seconds < 3600)) return fail_lease(link, lease, "a lease lasts more than 0 s, and less than 3600");
    ul_status status = read_lease(link, guard, &before);
    if (status != UL_OK) return status;
    if ((obstacle = obstacle_of(link, guard, &before)) != NULL) return fail_lease(link, lease, obstacle);
    lease->seconds = seconds;
    /* The token differs for all times within at least three seconds. It distinguishes programs, and is not secret. */
    lease->token = (before.clock * UINT64_C(0x9E3779B97F4A7C15)) >> (64 - LEASE_TOKEN_BITS);
    if (lease->finishes) lease->token |= UINT64_C(1) << LEASE_TOKEN_BITS;
    status = ul_set_unsigned(link, lease->arm, lease_word(link, lease, before.clock));
    if (status != UL_OK) return status;
    status = read_lease(link, guard, &after);
    if (status != UL_OK) return status;
    lease->count = after.arms;
    lease->session = link->session;
    if (after.state == LEASE_ARMED && after.arms == ((before.arms + 1) & 0xFFFF)) {
        note_arming(link, guard, after.arms);
        return UL_OK;
    }
    if ((obstacle = obstacle_of(link, guard, &after)) != NULL) return fail_lease(link, lease, obstacle);
    return fail_lease(link, lease, lease->finishes
        ? "it was not armed: the line takes longer than the lease, that is longer than TIMEOUT of the spec, or the spec has "
          "no FINISH"
        : "it was not armed: the line takes longer than the lease, or that is longer than TIMEOUT of the spec");
}

ul_status ul_lease_kick(ul_link *link, ul_lease *lease)
{
    const ul_guard *guard = lease->armed->signal.guard;
    char why[192];
    lease_state is;
    /* After a reset the count of leases starts again, so that another program's lease may have the same count. */
    if (link->open && lease->session != link->session) return fail_lease(link, lease, "it was armed in another session: arm it again");
    ul_status status = read_lease(link, guard, &is);
    if (status != UL_OK) return status;
    if (is.state == LEASE_ARMED && is.arms == lease->count)
        return ul_set_unsigned(link, lease->kick, lease_word(link, lease, is.clock));
    show_why(link, guard, &is, why, sizeof why);
    return fail_lease(link, lease, is.state == LEASE_ARMED ? "it has ended, and another program has armed it since" : why);
}

ul_status ul_lease_disarm(ul_link *link, const ul_lease *lease)
{
    return ul_set_unsigned(link, lease->disarm, 1);
}
