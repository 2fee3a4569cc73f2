-- SPDX-License-Identifier: BSD-3-Clause
--
-- A schedule: batches of words wait in a queue, each for its instant, and act in exactly that cycle.
--
-- The words of a batch that is complete go, one in each cycle, into shadows beside the registers that they are meant
-- for. There they wait for `commit`, which takes all of them over at once. So nothing that the bus does delays them.
--
-- In the queue stand a header, the words of the batch in their order, and its instant last: where the memory's output
-- shows it while it is waited for. The memory reads at the index of the next cycle, so that `word` is the one at
-- `read_at`.
--
-- A batch ends once, in the order of the batches. Those that are refused as they come have no place in the queue: a
-- header is kept with the number of its batch, and numbers that are left out are those of batches that were refused.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_schedule is
  generic (
    -- 1: a schedule has one queue.
    axes : positive := 1;
    -- At least 1: Hz of clk; instants are cycles of it.
    clock_hz : positive := 50_000_000;
    -- A power of two, 8 to 16384: words of the queue.
    depth : positive := 1024
  );
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- Synchronous, active high, for one cycle or more; nothing that came before it acts.
    rst : in    std_logic;
    -- Cycles of clk, as the gateway counts them.
    now : in    std_logic_vector(63 downto 0);
    -- '0': nothing acts, in this cycle and later, of batches that began before it is '1' again.
    armed : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- '1': as armed is, but for batches that are in the queue, which act.
    finishing : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- '1': nothing is in the queue.
    empty : out   std_logic_vector(axes - 1 downto 0);
    -- A word of a batch.
    entry : in    std_logic_vector(axes * 32 - 1 downto 0);
    -- '1': there is another one.
    entry_written : in    std_logic_vector(axes - 1 downto 0);
    -- Not needed: any write cancels.
    cancel : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- '1': nothing acts of what came before, nor of this cycle. The next word begins a batch.
    cancel_written : in    std_logic_vector(axes - 1 downto 0);
    -- Now, for who reads the registers.
    clock : out   std_logic_vector(axes * 64 - 1 downto 0);
    -- Batches that have ended since the reset (bits 15 to 0; goes round), and the ends of the last 48 of them, that of
    -- the newest at bit 16: 1 for one that has not acted.
    fates : out   std_logic_vector(axes * 64 - 1 downto 0);
    -- Batches since the reset whose instant was too near; goes round.
    late : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- Batches since the reset that were cancelled, did not fit, were malformed or not armed; goes round.
    refused : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- Words that are free in the queue.
    room : out   std_logic_vector(axes * 16 - 1 downto 0);
    -- Signed: the least number of cycles from the last word of a batch in the queue to its instant, since the reset or
    -- the last cancel; saturates.
    slack : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- '1': a word goes into a shadow.
    stage_write : out   std_logic;
    -- Of the shadow.
    stage_index : out   std_logic_vector(15 downto 0);
    -- The word.
    stage_data : out   std_logic_vector(31 downto 0);
    -- '1': what the shadows have is void.
    stage_clear : out   std_logic;
    -- '1' in the cycle before the instant: registers take what their shadows have.
    commit : out   std_logic
  );
end entity ul_schedule;

architecture rtl of ul_schedule is

  constant index_bits : positive := log2_ceil(depth);

  -- One bit more than an index, which tells full from empty.
  subtype pointer_t is unsigned(index_bits downto 0);

  subtype number_t is unsigned(15 downto 0);

  subtype instant_t is unsigned(39 downto 0);

  type part_t is (header_part, instant_part, body_part);

  type state_t is (header, numbered, run, value, instant, settling, waiting, acting, dropping);

  -- What was taken.
  signal word_given  : std_logic_vector(31 downto 0);
  signal is_given    : std_logic;
  signal part        : part_t;
  signal words_left  : unsigned(7 downto 0);
  signal is_good     : std_logic;
  signal began_well  : std_logic;
  signal fits        : std_logic;
  signal is_last     : std_logic;
  signal ends        : std_logic;
  signal accepts     : std_logic;
  signal instant_not : instant_t;
  signal ended       : number_t;

  -- The queue: complete batches up to `base`.
  signal base        : pointer_t;
  signal write_at    : pointer_t;
  signal write_index : unsigned(index_bits - 1 downto 0);
  signal write       : std_logic;
  signal write_data  : std_logic_vector(31 downto 0);
  signal free_but_1  : pointer_t;
  signal is_empty    : std_logic;
  signal read_at     : pointer_t;
  signal read_next   : pointer_t;
  signal word        : std_logic_vector(31 downto 0);

  -- The batch that is staged.
  signal state     : state_t;
  signal has_batch : std_logic;
  signal is_later  : std_logic;
  signal refuses   : std_logic;
  signal advances  : std_logic;
  signal words     : unsigned(7 downto 0);
  signal run_rest  : unsigned(7 downto 0);
  signal is_first  : std_logic;
  signal is_wrong  : std_logic;
  signal stage_at  : unsigned(15 downto 0);
  signal upper     : std_logic_vector(7 downto 0);
  signal data      : std_logic_vector(31 downto 0);
  signal ahead     : instant_t;
  signal voids     : std_logic;
  signal closed    : std_logic;
  signal commits   : std_logic;
  signal drops     : std_logic;

  -- What became of batches.
  signal finished      : number_t;
  signal last_ends     : std_logic_vector(47 downto 0);
  signal late_count    : unsigned(31 downto 0);
  signal refused_count : unsigned(31 downto 0);
  signal gap_not       : signed(39 downto 0);
  signal has_gap       : std_logic;
  signal is_less       : std_logic;
  signal below_least   : signed(40 downto 0);
  signal least         : signed(31 downto 0);

begin

  assert axes = 1
    report "ul_schedule: axes is " & integer'image(axes) & ": 1 was expected"
    severity failure;

  assert is_power_of_two(depth) and depth >= 8 and depth <= 16384
    report "ul_schedule: depth is " & integer'image(depth) & ": a power of two from 8 to 16384 was expected"
    severity failure;

  word_given <= entry(31 downto 0);
  is_given   <= entry_written(0);
  voids      <= cancel_written(0) or not armed(0);
  closed     <= voids or finishing(0);
  empty(0)   <= is_empty;
  is_empty   <= to_std_logic(std_logic_vector(read_at) = std_logic_vector(base));

  -- What comes in.

  -- depth - (base - read_at) - 1, by one addition: to add a depth, the highest bit is inverted.
  free_but_1 <= (not read_at(index_bits) & read_at(index_bits - 1 downto 0)) + not base;

  fits       <= '1' when free_but_1(index_bits) = '0' and
                         unsigned(word_given(31 downto 24)) < free_but_1(index_bits - 1 downto 0) else
                '0';
  began_well <= '1' when fits = '1' and unsigned(word_given(31 downto 8)) >= 2 ** 16 and
                         unsigned(word_given(23 downto 8)) = 0 else
                '0';

  with part select is_last <=
    '0' when header_part,
    to_std_logic(words_left = 0) when instant_part,
    to_std_logic(words_left = 1) when body_part;

  ends    <= is_given and is_last;
  accepts <= ends and is_good and not closed;

  take : process (clk) is

    variable write_next : unsigned(index_bits + 1 downto 0);

  begin

    if rising_edge(clk) then
      if is_given = '1' then

        case part is

          when header_part =>

            words_left                <= unsigned(word_given(31 downto 24));
            is_good                   <= began_well;
            instant_not(39 downto 32) <= unsigned(not word_given(7 downto 0));
            part                      <= instant_part;

          when instant_part =>

            instant_not(31 downto 0) <= unsigned(not word_given);
            part                     <= body_part;

          when body_part =>

            words_left <= words_left - 1;

        end case;

      end if;

      -- The place of the instant, behind the last word, is passed with it.
      write_next := (write_at & '1') + (to_unsigned(1, write_at'length) & ends);
      if is_given = '1' and part /= instant_part then
        write_at <= write_next(index_bits + 1 downto 1);
      end if;
      if ends = '1' then
        part     <= header_part;
        ended    <= ended + 1;
        write_at <= base;
      end if;
      if accepts = '1' then
        base     <= write_next(index_bits + 1 downto 1);
        write_at <= write_next(index_bits + 1 downto 1);
      end if;
      room <= std_logic_vector(resize(free_but_1 + 1, 16));

      if closed = '1' then
        is_good <= '0';
      end if;
      if voids = '1' then
        base     <= (others => '0');
        write_at <= (others => '0');
      end if;
      if cancel_written(0) = '1' then
        part <= header_part;
        if part /= header_part then
          ended <= ended + 1;
        end if;
      end if;
      if rst = '1' then
        part     <= header_part;
        base     <= (others => '0');
        write_at <= (others => '0');
        ended    <= (others => '0');
        room     <= std_logic_vector(to_unsigned(depth, 16));
      end if;
    end if;

  end process take;

  write       <= is_given and fits when part = header_part else
                 is_given and is_good;
  write_index <= write_at(write_index'range) + resize(words_left, index_bits) when part = instant_part else
                 write_at(write_index'range);
  write_data  <= word_given(31 downto 24) & std_logic_vector(ended) & word_given(7 downto 0) when part = header_part else
                 word_given;

  queue : entity work.ul_word_memory
    generic map (
      width => 32,
      depth => depth
    )
    port map (
      clk         => clk,
      write       => write,
      write_index => write_index,
      write_data  => write_data,
      read_index  => read_next(index_bits - 1 downto 0),
      read_data   => word
    );

  -- The words of the next batch go into shadows, and wait.

  -- `data` is what `word` was a cycle ago.
  is_later <= to_std_logic(data(23 downto 8) /= std_logic_vector(finished));

  -- Of those that have no place in the queue.
  refuses <= '1' when state = numbered and (has_batch = '0' or is_later = '1') else
             '0';

  with state select advances <=
    has_batch and not is_later when numbered,
    '1' when run | value | acting | dropping,
    '0' when others;

  read_next <= (others => '0') when voids = '1' else
               read_at + 1 when advances = '1' else
               read_at;

  stage : process (clk) is
  begin

    if rising_edge(clk) then
      read_at     <= read_next;
      has_batch   <= not is_empty;
      stage_write <= '0';
      stage_clear <= '0';
      data        <= word;
      -- The time to the instant, without this cycle.
      ahead <= unsigned(upper & data) + not unsigned(now(39 downto 0));

      case state is

        when header =>

          words    <= unsigned(word(31 downto 24));
          upper    <= word(7 downto 0);
          is_wrong <= '0';
          if is_empty = '0' or ended /= finished then
            state <= numbered;
          end if;

        when numbered =>

          state <= header;
          if advances = '1' then
            state <= run;
          end if;

        when run =>

          words    <= words - 1;
          run_rest <= unsigned(word(23 downto 16));
          stage_at <= unsigned(word(15 downto 0));
          is_first <= '1';
          state    <= value;
          if words = 1 then
            state    <= instant;
            is_wrong <= '1';
          end if;

        when value =>

          words       <= words - 1;
          run_rest    <= run_rest - 1;
          stage_write <= '1';
          is_first    <= '0';
          if is_first = '0' then
            stage_at <= stage_at + 1;
          end if;
          if words = 1 then
            state <= instant;
          elsif run_rest = 1 then
            state <= run;
          end if;
          -- An empty run has too many words, too.
          if (words = 1 and run_rest /= 1) or (is_first = '1' and unsigned(data(31 downto 24)) /= 0) then
            is_wrong <= '1';
          end if;

        when instant =>

          state <= settling;
          if is_wrong = '1' then
            state <= dropping;
          end if;

        when settling =>

          state <= waiting;

        when waiting =>

          if ahead = 2 then
            state <= acting;
          elsif ahead(39) = '1' or ahead < 2 then
            state <= dropping;
          end if;

        when acting =>

          state <= header;

        when dropping =>

          stage_clear <= '1';
          state       <= header;

      end case;

      -- The batches of the queue are refused as those that have no place in it.
      if voids = '1' then
        has_batch   <= '0';
        stage_write <= '0';
        stage_clear <= '1';
        if state /= header then
          state <= header;
        end if;
      end if;
      if rst = '1' then
        read_at     <= (others => '0');
        stage_write <= '0';
        stage_clear <= '0';
        stage_at    <= (others => '0');
        state       <= header;
      end if;
    end if;

  end process stage;

  stage_data  <= data;
  stage_index <= std_logic_vector(stage_at);
  commits     <= '1' when state = acting and voids = '0' and rst = '0' else
                 '0';
  commit      <= commits;

  -- How it ended.

  drops <= '1' when state = dropping and voids = '0' else
           '0';

  -- least - gap - 1. Complements make additions of subtractions: before a carry an inverter is a cell of its own.
  below_least <= resize(least, 41) + resize(gap_not, 41);
  is_less     <= not below_least(40);

  count : process (clk) is
  begin

    if rising_edge(clk) then
      if commits = '1' or drops = '1' or refuses = '1' then
        finished  <= finished + 1;
        last_ends <= last_ends(46 downto 0) & not commits;
      end if;
      if drops = '1' and is_wrong = '0' then
        late_count <= late_count + 1;
      end if;
      if refuses = '1' or (drops = '1' and is_wrong = '1') then
        refused_count <= refused_count + 1;
      end if;

      gap_not <= signed(instant_not + unsigned(now(39 downto 0)));
      has_gap <= accepts;
      if has_gap = '1' and is_less = '1' then
        least <= not gap_not(31 downto 0);
        if gap_not(39) = '0' and gap_not(38 downto 31) /= 0 then
          least <= (31 => '1', others => '0');
        end if;
      end if;

      if cancel_written(0) = '1' or rst = '1' then
        least   <= (31 => '0', others => '1');
        has_gap <= '0';
      end if;
      if rst = '1' then
        finished      <= (others => '0');
        last_ends     <= (others => '0');
        late_count    <= (others => '0');
        refused_count <= (others => '0');
      end if;
    end if;

  end process count;

  clock   <= now;
  fates   <= last_ends & std_logic_vector(finished);
  late    <= std_logic_vector(late_count);
  refused <= std_logic_vector(refused_count);
  slack   <= std_logic_vector(least);

end architecture rtl;
