"""Words that an identifier of generated C and C++ cannot be: those of the languages, their libraries and the runtime.

The preprocessor replaces a macro everywhere, so that not even a member can have its name; a function or type of a
library conflicts only with global names. The lists of macros and functions are those that the headers of C99,
POSIX.1-2008 and C++17 define in GNU's libraries.
"""

from __future__ import annotations

import re

_C = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
"""
_CPP = """
    alignas alignof and and_eq asm bitand bitor bool catch char8_t char16_t char32_t class co_await co_return co_yield
    compl concept const_cast consteval constexpr constinit decltype delete dynamic_cast explicit export false friend
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast
    requires static_assert static_cast template this thread_local throw true try typeid typename using virtual wchar_t
    xor xor_eq
"""
_MACROS = """
    i386 imaginary linux major minor noreturn unix
    BIG_ENDIAN BUFSIZ BYTE_ORDER CLOCKS_PER_SEC CSIGNAL DECIMAL_DIG E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV
    EAFNOSUPPORT EAGAIN EALREADY EBADE EBADF EBADFD EBADMSG EBADR EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECHILD
    ECHRNG ECOMM ECONNABORTED ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EDESTADDRREQ EDOM EDOTDOT EDQUOT EEXIST
    EFAULT EFBIG EHOSTDOWN EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN EISDIR EISNAM
    EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD ELIBEXEC ELIBMAX ELIBSCN
    ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG ENAVAIL ENETDOWN ENETRESET ENETUNREACH
    ENFILE ENOANO ENOBUFS ENOCSI ENODATA ENODEV ENOENT ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET
    ENOPKG ENOPROTOOPT ENOSPC ENOSR ENOSTR ENOSYS ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE
    ENOTSOCK ENOTSUP ENOTTY ENOTUNIQ ENXIO EOF EOPNOTSUPP EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO
    EPROTONOSUPPORT EPROTOTYPE ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN ESOCKTNOSUPPORT
    ESPIPE ESRCH ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY EUCLEAN EUNATCH EUSERS EWOULDBLOCK
    EXDEV EXFULL EXIT_FAILURE EXIT_SUCCESS FD_CLR FD_ISSET FD_SET FD_SETSIZE FD_ZERO FILENAME_MAX FOPEN_MAX HUGE_VAL
    HUGE_VALF HUGE_VALL INFINITY LITTLE_ENDIAN L_ctermid L_cuserid L_tmpnam MATH_ERREXCEPT MATH_ERRNO MB_CUR_MAX
    MB_LEN_MAX NAN NFDBITS NULL PDP_ENDIAN P_tmpdir RAND_MAX RENAME_EXCHANGE RENAME_NOREPLACE RENAME_WHITEOUT
    SEEK_CUR SEEK_DATA SEEK_END SEEK_HOLE SEEK_SET SIGABRT SIGALRM SIGBUS SIGCHLD SIGCLD SIGCONT SIGFPE SIGHUP
    SIGILL SIGINT SIGIO SIGIOT SIGKILL SIGPIPE SIGPOLL SIGPROF SIGPWR SIGQUIT SIGRTMAX SIGRTMIN SIGSEGV SIGSTKFLT
    SIGSTOP SIGSYS SIGTERM SIGTRAP SIGTSTP SIGTTIN SIGTTOU SIGURG SIGUSR1 SIGUSR2 SIGVTALRM SIGWINCH SIGXCPU SIGXFSZ
    TIME_UTC TMP_MAX WCONTINUED WEOF WEXITED WEXITSTATUS WIFCONTINUED WIFEXITED WIFSIGNALED WIFSTOPPED WNOHANG
    WNOWAIT WSTOPPED WSTOPSIG WTERMSIG WUNTRACED alloca assert be16toh be32toh be64toh complex errno fpclassify
    htobe16 htobe32 htobe64 htole16 htole32 htole64 isalnum isalpha isblank iscntrl isdigit isfinite isgraph
    isgreater isgreaterequal isinf isless islessequal islessgreater islower isnan isnormal isprint ispunct isspace
    isunordered isupper isxdigit le16toh le32toh le64toh math_errhandling offsetof pthread_cleanup_pop
    pthread_cleanup_pop_restore_np pthread_cleanup_push pthread_cleanup_push_defer_np sched_priority setjmp signbit
    stderr stdin stdout va_arg va_copy va_end va_start
"""
_FAMILIES = re.compile(
    r"(?:PRI|SCN)[A-Za-z]\w*|U?INT(?:_FAST|_LEAST)?(?:\d+|MAX|PTR)?_(?:C|MAX|MIN|WIDTH)|SIG_\w+"
    r"|(?:S|U)?CHAR_\w+|U?SHRT_\w+|U?LL?ONG_\w+|S?SIZE_(?:MAX|WIDTH)|(?:PTRDIFF|WCHAR|WINT)_(?:MAX|MIN|WIDTH)"
    r"|(?:ADJ|ATOMIC|CLOCK|CLONE|CPU|D?BL|DEC\d+|FE|FLT\w*|FP|LC|LDBL|M|MOD|PTHREAD|SCHED|STA|TIMER)_\w+"
    r"|(?:ul|UL|unity_link|UNITY_LINK)_\w+"
)
"""Prefixes of macros and of the runtime's names. None of these names ends in ``_`` like a renamed identifier, or
contains ``__`` like a name derived from one."""
_SCOPES = """
    int64_t place std the_link uint32_t uint64_t uint8_t unity_link
"""
"""Names that members of generated structures and classes must not hide."""
_LIBRARY = """
    DIR FILE a64l abort abs accept access acos acosf acosh acoshf acoshl acosl alarm aligned_alloc alphasort
    arc4random arc4random_buf arc4random_uniform asctime asctime_r asin asinf asinh asinhf asinhl asinl asprintf
    at_quick_exit atan atan2 atan2f atan2l atanf atanh atanhf atanhl atanl atexit atof atoi atol atoll basename bcmp
    bcopy bind bsearch btowc bzero calloc canonicalize canonicalize_file_name canonicalizef canonicalizel cbrt cbrtf
    cbrtl ceil ceilf ceill cfgetispeed cfgetospeed cfsetispeed cfsetospeed chdir chmod chown clearenv clearerr
    clearerr_unlocked clock clock_adjtime clock_getcpuclockid clock_getres clock_gettime clock_nanosleep
    clock_settime clone close closedir confstr connect copysign copysignf copysignl cos cosf cosh coshf coshl cosl
    creat ctermid ctime ctime_r cuserid daddl daylight ddivl dfmal difftime dirfd div dmull dprintf drand48
    drand48_r drem dremf dreml dsqrtl dsubl dup dup2 duplocale dysize ecvt ecvt_r endhostent endnetent endprotoent
    endservent erand48 erand48_r erf erfc erfcf erfcl erff erfl execl execle execlp execv execve execvp exit exp
    exp10 exp10f exp10l exp2 exp2f exp2l expf expl explicit_bzero expm1 expm1f expm1l fabs fabsf fabsl faccessat
    fadd faddl fchdir fchmod fchmodat fchown fchownat fclose fcloseall fcntl fcvt fcvt_r fd_mask fd_set fdatasync
    fdim fdimf fdiml fdiv fdivl fdopen fdopendir feclearexcept fegetenv fegetexceptflag fegetround feholdexcept feof
    feof_unlocked feraiseexcept ferror ferror_unlocked fesetenv fesetexceptflag fesetround fetestexcept feupdateenv
    fexecve fflush fflush_unlocked ffma ffmal ffs ffsl ffsll fgetc fgetc_unlocked fgetpos fgetpos64 fgets
    fgets_unlocked fgetwc fgetwc_unlocked fgetws fgetws_unlocked fileno fileno_unlocked finite finitef finitel
    flockfile floor floorf floorl fma fmaf fmal fmax fmaxf fmaximum fmaximum_mag fmaximum_mag_num fmaximum_mag_numf
    fmaximum_mag_numl fmaximum_magf fmaximum_magl fmaximum_num fmaximum_numf fmaximum_numl fmaximumf fmaximuml fmaxl
    fmaxmag fmaxmagf fmaxmagl fmemopen fmin fminf fminimum fminimum_mag fminimum_mag_num fminimum_mag_numf
    fminimum_mag_numl fminimum_magf fminimum_magl fminimum_num fminimum_numf fminimum_numl fminimumf fminimuml fminl
    fminmag fminmagf fminmagl fmod fmodf fmodl fmul fmull fopen fopen64 fopencookie fork fpathconf fprintf fputc
    fputc_unlocked fputs fputs_unlocked fputwc fputwc_unlocked fputws fputws_unlocked fread fread_unlocked free
    freeaddrinfo freelocale freopen freopen64 frexp frexpf frexpl fromfp fromfpf fromfpl fromfpx fromfpxf fromfpxl
    fscanf fseek fseeko fseeko64 fsetpos fsetpos64 fsqrt fsqrtl fstat fstatat fsub fsubl fsync ftell ftello ftello64
    ftruncate ftrylockfile funlockfile futimens fwide fwprintf fwrite fwrite_unlocked fwscanf gai_strerror gamma
    gammaf gammal gcvt getaddrinfo getc getc_unlocked getchar getchar_unlocked getcpu getcwd getdate getdate_err
    getdate_r getdelim getegid getenv geteuid getgid getgroups gethostbyaddr gethostbyname gethostent gethostname
    getitimer getline getloadavg getlogin getlogin_r getnameinfo getnetbyaddr getnetbyname getnetent getopt
    getpayload getpayloadf getpayloadl getpeername getpgid getpgrp getpid getppid getprotobyname getprotobynumber
    getprotoent getpt gets getservbyname getservbyport getservent getsid getsockname getsockopt getsubopt
    gettimeofday getuid getw getwc getwc_unlocked getwchar getwchar_unlocked gmtime gmtime_r grantpt htonl htons
    hypot hypotf hypotl ilogb ilogbf ilogbl imaxabs imaxdiv in6addr_any in6addr_loopback index inet_addr inet_lnaof
    inet_makeaddr inet_netof inet_network inet_ntoa inet_ntop inet_pton initstate initstate_r ioctl isalnum_l
    isalpha_l isascii isatty isblank_l iscntrl_l isctype isdigit_l isgraph_l isinff isinfl islower_l isnanf isnanl
    isprint_l ispunct_l isspace_l isupper_l iswalnum iswalnum_l iswalpha iswalpha_l iswblank iswblank_l iswcntrl
    iswcntrl_l iswctype iswctype_l iswdigit iswdigit_l iswgraph iswgraph_l iswlower iswlower_l iswprint iswprint_l
    iswpunct iswpunct_l iswspace iswspace_l iswupper iswupper_l iswxdigit iswxdigit_l isxdigit_l j0 j0f j0l j1 j1f
    j1l jn jnf jnl jrand48 jrand48_r kill l64a labs lchown lcong48 lcong48_r ldexp ldexpf ldexpl ldiv lgamma
    lgamma_r lgammaf lgammaf128_r lgammaf32_r lgammaf32x_r lgammaf64_r lgammaf64x_r lgammaf_r lgammal lgammal_r link
    linkat listen llabs lldiv llogb llogbf llogbl llrint llrintf llrintl llround llroundf llroundl localeconv
    localtime localtime_r log log10 log10f log10l log1p log1pf log1pl log2 log2f log2l logb logbf logbl logf logl
    longjmp lrand48 lrand48_r lrint lrintf lrintl lround lroundf lroundl lseek lstat malloc mblen mbrlen mbrtowc
    mbsinit mbsnrtowcs mbsrtowcs mbstowcs mbtowc memccpy memchr memcmp memcpy memfrob memmem memmove mempcpy memrchr
    memset mkdir mkdirat mkdtemp mkfifo mkfifoat mkostemp mkostemp64 mkostemps mkostemps64 mkstemp mkstemp64
    mkstemps mkstemps64 mktemp mktime modf modff modfl mrand48 mrand48_r nan nanf nanl nanosleep nearbyint
    nearbyintf nearbyintl newlocale nextafter nextafterf nextafterl nextdown nextdownf nextdownl nexttoward
    nexttowardf nexttowardl nextup nextupf nextupl nrand48 nrand48_r ntohl ntohs obstack_printf obstack_vprintf
    on_exit open open_memstream open_wmemstream openat opendir optarg opterr optind optopt pathconf pause pclose
    perror pipe poll popen posix_fadvise posix_fallocate posix_memalign posix_openpt pow powf powl pread printf
    program_invocation_name program_invocation_short_name pselect psiginfo psignal pthread_atfork
    pthread_attr_destroy pthread_attr_getaffinity_np pthread_attr_getdetachstate pthread_attr_getguardsize
    pthread_attr_getinheritsched pthread_attr_getschedparam pthread_attr_getschedpolicy pthread_attr_getscope
    pthread_attr_getsigmask_np pthread_attr_getstack pthread_attr_getstackaddr pthread_attr_getstacksize
    pthread_attr_init pthread_attr_setaffinity_np pthread_attr_setdetachstate pthread_attr_setguardsize
    pthread_attr_setinheritsched pthread_attr_setschedparam pthread_attr_setschedpolicy pthread_attr_setscope
    pthread_attr_setsigmask_np pthread_attr_setstack pthread_attr_setstackaddr pthread_attr_setstacksize
    pthread_barrier_destroy pthread_barrier_init pthread_barrier_wait pthread_barrierattr_destroy
    pthread_barrierattr_getpshared pthread_barrierattr_init pthread_barrierattr_setpshared pthread_cancel
    pthread_clockjoin_np pthread_cond_broadcast pthread_cond_clockwait pthread_cond_destroy pthread_cond_init
    pthread_cond_signal pthread_cond_timedwait pthread_cond_wait pthread_condattr_destroy pthread_condattr_getclock
    pthread_condattr_getpshared pthread_condattr_init pthread_condattr_setclock pthread_condattr_setpshared
    pthread_create pthread_detach pthread_equal pthread_exit pthread_getaffinity_np pthread_getattr_default_np
    pthread_getattr_np pthread_getconcurrency pthread_getcpuclockid pthread_getname_np pthread_getschedparam
    pthread_getspecific pthread_join pthread_key_create pthread_key_delete pthread_kill pthread_mutex_clocklock
    pthread_mutex_consistent pthread_mutex_consistent_np pthread_mutex_destroy pthread_mutex_getprioceiling
    pthread_mutex_init pthread_mutex_lock pthread_mutex_setprioceiling pthread_mutex_timedlock pthread_mutex_trylock
    pthread_mutex_unlock pthread_mutexattr_destroy pthread_mutexattr_getprioceiling pthread_mutexattr_getprotocol
    pthread_mutexattr_getpshared pthread_mutexattr_getrobust pthread_mutexattr_getrobust_np
    pthread_mutexattr_gettype pthread_mutexattr_init pthread_mutexattr_setprioceiling pthread_mutexattr_setprotocol
    pthread_mutexattr_setpshared pthread_mutexattr_setrobust pthread_mutexattr_setrobust_np
    pthread_mutexattr_settype pthread_once pthread_rwlock_clockrdlock pthread_rwlock_clockwrlock
    pthread_rwlock_destroy pthread_rwlock_init pthread_rwlock_rdlock pthread_rwlock_timedrdlock
    pthread_rwlock_timedwrlock pthread_rwlock_tryrdlock pthread_rwlock_trywrlock pthread_rwlock_unlock
    pthread_rwlock_wrlock pthread_rwlockattr_destroy pthread_rwlockattr_getkind_np pthread_rwlockattr_getpshared
    pthread_rwlockattr_init pthread_rwlockattr_setkind_np pthread_rwlockattr_setpshared pthread_self
    pthread_setaffinity_np pthread_setattr_default_np pthread_setcancelstate pthread_setcanceltype
    pthread_setconcurrency pthread_setname_np pthread_setschedparam pthread_setschedprio pthread_setspecific
    pthread_sigmask pthread_spin_destroy pthread_spin_init pthread_spin_lock pthread_spin_trylock
    pthread_spin_unlock pthread_testcancel pthread_timedjoin_np pthread_tryjoin_np pthread_yield ptsname ptsname_r
    putc putc_unlocked putchar putchar_unlocked putenv puts putw putwc putwc_unlocked putwchar putwchar_unlocked
    pwrite qecvt qecvt_r qfcvt qfcvt_r qgcvt qsort qsort_r quick_exit raise rand rand_r random random_r rawmemchr
    read readdir readdir_r readlink readlinkat realloc reallocarray realpath recv recvfrom recvmsg remainder
    remainderf remainderl remove remquo remquof remquol rename renameat renameat2 rewind rewinddir rindex rint rintf
    rintl rmdir round roundeven roundevenf roundevenl roundf roundl rpmatch scalb scalbf scalbl scalbln scalblnf
    scalblnl scalbn scalbnf scalbnl scandir scanf sched_get_priority_max sched_get_priority_min sched_getaffinity
    sched_getcpu sched_getparam sched_getscheduler sched_rr_get_interval sched_setaffinity sched_setparam
    sched_setscheduler sched_yield secure_getenv seed48 seed48_r select send sendmsg sendto setbuf setbuffer setegid
    setenv seteuid setgid sethostent setitimer setlinebuf setlocale setnetent setns setpayload setpayloadf
    setpayloadl setpayloadsig setpayloadsigf setpayloadsigl setpgid setprotoent setservent setsid setsockopt
    setstate setstate_r setuid setvbuf shutdown sigabbrev_np sigaction sigaddset sigdelset sigdescr_np sigemptyset
    sigfillset sigismember siglongjmp signal signgam significand significandf significandl sigpending sigprocmask
    sigqueue sigsuspend sigtimedwait sigwait sigwaitinfo sin sincos sincosf sincosl sinf sinh sinhf sinhl sinl sleep
    snprintf sockatmark socket socketpair sprintf sqrt sqrtf sqrtl srand srand48 srand48_r srandom srandom_r sscanf
    stat stpcpy stpncpy strcasecmp strcasecmp_l strcasestr strcat strchr strchrnul strcmp strcoll strcoll_l strcpy
    strcspn strdup strerror strerror_l strerror_r strerrordesc_np strerrorname_np strfromd strfromf strfroml strfry
    strftime strftime_l strlen strncasecmp strncasecmp_l strncat strncmp strncpy strndup strnlen strpbrk strptime
    strptime_l strrchr strsep strsignal strspn strstr strtod strtod_l strtof strtof128_l strtof32_l strtof32x_l
    strtof64_l strtof64x_l strtof_l strtoimax strtok strtok_r strtol strtol_l strtold strtold_l strtoll strtoll_l
    strtoq strtoul strtoul_l strtoull strtoull_l strtoumax strtouq strverscmp strxfrm strxfrm_l swprintf swscanf
    symlink symlinkat sysconf system tan tanf tanh tanhf tanhl tanl tcdrain tcflow tcflush tcgetattr tcgetpgrp
    tcgetsid tcsendbreak tcsetattr tcsetpgrp tempnam tgamma tgammaf tgammal time timegm timelocal timer_create
    timer_delete timer_getoverrun timer_gettime timer_settime timespec_get timespec_getres timezone tmpfile
    tmpfile64 tmpnam tmpnam_r toascii tolower tolower_l totalorder totalorderf totalorderl totalordermag
    totalordermagf totalordermagl toupper toupper_l towctrans towctrans_l towlower towlower_l towupper towupper_l
    trunc truncate truncf truncl ttyname ttyname_r tzname tzset u_char u_int u_long u_short ufromfp ufromfpf
    ufromfpl ufromfpx ufromfpxf ufromfpxl uint ulong umask ungetc ungetwc unlink unlinkat unlockpt unsetenv unshare
    uselocale ushort utimensat utimes va_list valloc vasprintf vdprintf vfprintf vfscanf vfwprintf vfwscanf vprintf
    vscanf vsnprintf vsprintf vsscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb wcscasecmp
    wcscasecmp_l wcscat wcschr wcschrnul wcscmp wcscoll wcscoll_l wcscpy wcscspn wcsdup wcsftime wcsftime_l wcslen
    wcsncasecmp wcsncasecmp_l wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr
    wcstod wcstod_l wcstof wcstof128_l wcstof32_l wcstof32x_l wcstof64_l wcstof64x_l wcstof_l wcstoimax wcstok
    wcstol wcstol_l wcstold wcstold_l wcstoll wcstoll_l wcstombs wcstoq wcstoul wcstoul_l wcstoull wcstoull_l
    wcstoumax wcstouq wcswcs wcswidth wcsxfrm wcsxfrm_l wctob wctomb wctrans wctrans_l wctype wctype_l wcwidth
    wmemchr wmemcmp wmemcpy wmemmove wmempcpy wmemset wprintf write wscanf y0 y0f y0l y1 y1f y1l yn ynf ynl
    gamma j0 j1 jn lgamma main pow rint y0 y1 yn
"""
_OURS = re.compile(r"ul|unity_link(?:_posix)?", re.IGNORECASE)
"""Files of the runtime, and the prefix of its names."""
_LOCALS = """
    all base batch callback index link plain sample samples schedule seconds signal status subscription taken value
    values words
"""
"""Parameters and variables of generated functions, which would hide the constant of an interface."""
_HEADERS = """
    alloca assert complex ctype dirent endian errno fcntl features fenv float inttypes iso646 libgen limits locale math
    netdb poll pthread sched semaphore setjmp signal stdalign stdarg stdatomic stdbool stddef stdint stdio stdlib
    stdnoreturn string strings termios tgmath threads time uchar unistd utime wchar wctype
"""
"""System headers; a compiler would include the header of an interface of the same name instead."""

WORDS = frozenset(f"{_C}{_CPP}{_MACROS}{_SCOPES}".split())
GLOBALS = frozenset(_LIBRARY.split())
INTERFACES = frozenset(f"{_LOCALS}{_HEADERS}".split())


def is_word(identifier: str) -> bool:
    """Return whether a word is reserved everywhere, also for members."""
    renamed = identifier.endswith("_") or "__" in identifier
    return identifier in WORDS or (not renamed and _FAMILIES.fullmatch(identifier) is not None)


def is_global(identifier: str) -> bool:
    """Return whether a word is reserved for global names; POSIX reserves names that end in ``_t`` for types."""
    return is_word(identifier) or identifier in GLOBALS or identifier.endswith("_t")


def is_interface(identifier: str) -> bool:
    """Return whether a word is reserved for interfaces."""
    return is_global(identifier) or identifier in INTERFACES or _OURS.fullmatch(identifier) is not None
