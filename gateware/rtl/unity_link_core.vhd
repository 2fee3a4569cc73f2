-- SPDX-License-Identifier: BSD-3-Clause
--
-- The gateway without a medium and without a bus standard: byte streams on one side, the bus-independent interface on
-- the other.
--
--     rx -> FIFO -> ul_datalink_rx -> ul_request_decoder -> ul_request_executor -> ul_bus_master -> bus
--     tx <- FIFO <- ul_datalink_tx <- ul_frame_writer <-+- (responses)              ^
--                                                       +- (samples) <- ul_subscription_manager <- trigger, base tick
--
-- A request is parsed while it arrives and executed at its end. The next request is parsed and executed while the
-- previous answer is sent, so that a stream of reads keeps the transmitter busy in every cycle. See docs/gateware.md.
--
-- The bus-independent interface: while `bus_request` is '1', address, write and data are stable until the rising edge
-- at which `bus_done` is '1' (the first one if there are no wait states). `bus_error` and `bus_read_data` are valid at
-- that edge. `bus_request` is deasserted for at least one cycle between accesses. It is deasserted without `bus_done`
-- when the access has timed out: the access then counts as ended, and the bus is not used for `bus_timeout` cycles, so
-- that a late answer is not mistaken for that of another access. `bus_lock` stays '1' during all accesses of one atomic
-- transaction. `sample_strobe` is '1' for one cycle, the time of a group's sample: modules latch their values at the
-- end of this cycle, and reads while `sample_access` is '1' return the latched values.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity unity_link_core is
  generic (
    -- Whether the medium stops the host when the receive FIFO is full; Q reports it.
    flow_control : boolean := true;
    -- 8 to 64: bits of a word.
    data_bits : positive := 32;
    -- 8 to 32: bits of a word address.
    address_bits : positive := 8;
    -- 2, 3: hex digits of a message ID, for up to 128 or 2,048 requests in flight.
    id_digits : positive := 3;
    -- Whether the gateway has a datalink layer. If false, all frames are plain, for a person at a terminal; a host
    -- needs checked frames.
    checked_frames : boolean := true;
    -- 8, 16, 32: bits of the CRC of a frame.
    crc_bits : positive := 16;
    -- crc_bits bits, not all 0: polynomial of the CRC without its highest term, right-aligned. The default is for 16
    -- bits.
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021";
    -- 1 to 255: maximum number of words in one block or queue request.
    block_words : positive := 255;
    -- 0 to 256: number of publish groups.
    groups : natural := 16;
    -- 1 to 255: maximum number of addresses in one group.
    group_words : natural := 32;
    -- A power of two, at least group_words + 2: words of the buffer in which the samples of all groups wait for
    -- transmission.
    sample_depth : positive := 256;
    -- At least 1: frequency of clk in Hz, from which all intervals are derived.
    clock_hz : positive := 50_000_000;
    -- 1 to 1000 * clock_hz / (groups + 8): frequency of the base tick in mHz; periodic groups publish at integer
    -- divisions of it.
    base_frequency_millihertz : positive := 100_000_000;
    -- Powers of two, 2 to 32768: bytes of the receive FIFO and of the transmit FIFO.
    rx_fifo_depth : positive := 256;
    tx_fifo_depth : positive := 256;
    -- 0 to 32767: bytes of buffer in the medium in front of the receive FIFO; Q reports the sum of both.
    medium_bytes : natural := 0;
    -- At least 1: cycles after which an unanswered bus access ends with error 05; the bus is then released for as long.
    bus_timeout : positive := 1024;
    -- Whether the bus may accept an access before it has answered the previous one: bus_ahead and bus_next.
    bus_pipelined : boolean := true;
    -- Whether the gateway has the command WK. If false, WK is answered with error 02, like all commands that are left
    -- out.
    masked_write : boolean := true;
    -- Whether the gateway has the commands RQ and WQ, for FIFOs at one address.
    queue_commands : boolean := true;
    -- Whether frames of a session may use the compact form; words must have an even number of hex digits then.
    compact : boolean := false;
    -- Whether samples can have a timestamp. If false, the group flag for it is answered with error 06.
    timestamps : boolean := true;
    -- Whether edges of trigger can make groups due. If false, the group flag for it is answered with error 06.
    triggers : boolean := true;
    -- Whether the gateway makes the medium send its buffer at once after an answer.
    send_immediate : boolean := true;
    -- -1 to 254: number of this node on a shared medium; -1 if the medium is not shared.
    node : integer := -1;
    -- Whether only one side may send at a time; groups then publish only on request by GP.
    half_duplex : boolean := false;
    -- Any: build identifier that Q reports.
    build_id : std_logic_vector(31 downto 0) := x"00000000";
    -- Whether build_id is the fingerprint of a spec's address map, which hosts compare with their own.
    fingerprint : boolean := false;
    -- Whether the highest addresses contain a description of the registers, in the format of docs/protocol.md.
    description : boolean := false
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Byte from the medium. It is transferred at the rising edge at which rx_valid and rx_ready are both '1'.
    rx_data : in    std_logic_vector(7 downto 0);
    -- Valid with rx_data: '1' if bytes before this one were lost.
    rx_lost : in    std_logic := '0';
    -- rx_data is valid.
    rx_valid : in    std_logic;
    -- The gateway accepts the byte.
    rx_ready : out   std_logic;
    -- Byte for the medium.
    tx_data : out   std_logic_vector(7 downto 0);
    -- tx_data is valid.
    tx_valid : out   std_logic;
    -- The medium accepts the byte.
    tx_ready : in    std_logic;
    -- '1' if the bytes at rx_data belong to no session and must not change the session. Stable while the core has
    -- bytes, requests or answers other than samples.
    no_session : in    std_logic := '0';
    -- '1' for one cycle: send all bytes so far at once.
    flush : out   std_logic;
    -- The core has a byte, a request or an answer.
    active : out   std_logic;
    -- A rising edge makes the group of that number due. High and low times must be at least two cycles. Clock: none.
    trigger : in    std_logic_vector(maximum(groups, 1) - 1 downto 0) := (others => '0');
    -- An access is requested; the next three signals are stable until it is done. '0' for at least one cycle between
    -- accesses.
    bus_request : out   std_logic;
    -- '1' for a write, '0' for a read.
    bus_write : out   std_logic;
    -- '1' during all accesses of one atomic bus transaction.
    bus_lock : out   std_logic;
    -- '1' if further reads of the same transaction may be requested before this one is answered.
    bus_ahead : out   std_logic;
    -- The read is accepted; its answer comes later. '0' without bus_pipelined.
    bus_next : in    std_logic := '0';
    -- Word address.
    bus_address : out   std_logic_vector(address_bits - 1 downto 0);
    -- Word to write.
    bus_write_data : out   std_logic_vector(data_bits - 1 downto 0);
    -- Valid with bus_done: the word read.
    bus_read_data : in    std_logic_vector(data_bits - 1 downto 0);
    -- '1' at the edge at which the access ends, which may be its first edge.
    bus_done : in    std_logic;
    -- Valid with bus_done: '1' if the access failed.
    bus_error : in    std_logic;
    -- '1' for one cycle, at the time of a sample's timestamp: modules latch their values at the end of this cycle.
    sample_strobe : out   std_logic;
    -- '1' from the cycle after sample_strobe until the last word of the sample was read.
    sample_access : out   std_logic;
    -- '1' for one cycle at each base tick; periodic groups publish at integer divisions of it. It is never delayed, and
    -- also runs without groups.
    base_tick : out   std_logic;
    -- Cycles since the reset; timestamps of samples are its lower half.
    timestamp : out   std_logic_vector(63 downto 0)
  );
end entity unity_link_core;

architecture rtl of unity_link_core is

  -- Clamped so that elaboration reaches the assertions below even if they fail: without groups, and with memories of at
  -- most the largest size.
  constant has_groups    : boolean  := groups > 0 and groups <= 256 and group_words > 0 and group_words <= 255;
  constant address_width : positive := 4 * digits_of(address_bits);
  constant id_width      : positive := 4 * id_digits;
  constant memory_width  : positive := maximum(data_bits, address_bits);
  constant sample_width  : positive := maximum(4 * digits_of(data_bits), 32);

  function words_in_request return positive is
  begin

    if has_groups then
      return minimum(maximum(block_words, maximum(group_words, 2)), 256);
    end if;
    return minimum(maximum(block_words, 2), 256);

  end function words_in_request;

  constant memory_depth   : positive := 2 ** log2_ceil(words_in_request);
  constant response_depth : positive := 2 ** log2_ceil(maximum(block_words, 2));
  constant response_bits  : positive := log2_ceil(response_depth) + 1;
  constant room_bits      : positive := log2_ceil(sample_depth) + 1;
  constant longest        : positive := longest_request(
                                                        data_bits, address_bits, id_digits, crc_bits, block_words,
                                                        groups, group_words, masked_write
                                                      );

  function features return std_logic_vector is

    variable bits : std_logic_vector(15 downto 0) := (others => '0');

  begin

    bits(feature_groups)            := to_std_logic(has_groups);
    bits(feature_external_triggers) := to_std_logic(triggers and has_groups);
    bits(feature_timestamps)        := to_std_logic(timestamps and has_groups);
    bits(feature_send_immediate)    := to_std_logic(send_immediate);
    bits(feature_flow_control)      := to_std_logic(flow_control);
    bits(feature_masked_write)      := to_std_logic(masked_write);
    bits(feature_queue_commands)    := to_std_logic(queue_commands);
    bits(feature_addressed)         := to_std_logic(node >= 0);
    bits(feature_fingerprint)       := to_std_logic(fingerprint);
    bits(feature_half_duplex)       := to_std_logic(half_duplex);
    bits(feature_description)       := to_std_logic(description);
    bits(feature_compact)           := to_std_logic(compact);
    return bits;

  end function features;

  function digits (value, bits : natural) return std_logic_vector is
  begin

    return std_logic_vector(to_unsigned(value, bits));

  end function digits;

  -- Content of the answer to `Q` (docs/protocol.md, "Configuration").
  function q_answer return std_logic_vector is
  begin

    return x"03" & digits(data_bits, 8) & digits(address_bits, 8) & digits(id_digits, 8) & digits(crc_bits, 8)
           & crc_polynomial & digits(block_words, 8) & digits(groups, 16) & digits(group_words, 8)
           & digits(base_frequency_millihertz, 40) & digits(clock_hz, 32) & digits(rx_fifo_depth + medium_bytes, 16)
           & digits(tx_fifo_depth, 16) & features & build_id;

  end function q_answer;

  -- Received bytes.
  signal fifo_in         : std_logic_vector(8 downto 0);
  signal fifo_out        : std_logic_vector(8 downto 0);
  signal fifo_out_valid  : std_logic;
  signal fifo_out_ready  : std_logic;
  signal byte_in         : std_logic_vector(8 downto 0);
  signal byte_valid      : std_logic;
  signal byte_ready      : std_logic;
  signal character_in    : std_logic_vector(8 downto 0);
  signal character_valid : std_logic;
  signal character_ready : std_logic;

  -- Bodies of received frames.
  signal body_data   : std_logic_vector(7 downto 0);
  signal body_valid  : std_logic;
  signal body_ready  : std_logic;
  signal body_last   : std_logic;
  signal body_plain  : std_logic;
  signal body_error  : error_t;
  signal body_silent : std_logic;
  signal residue     : std_logic_vector(crc_bits - 1 downto 0);

  -- Session.
  signal session      : std_logic_vector(4 * session_digits_of(crc_bits) - 1 downto 0);
  signal in_session   : std_logic;
  signal for_program  : std_logic;
  signal drop_samples : std_logic;
  -- The session to which the received frames belong.
  signal taken_session : std_logic_vector(session'range);
  signal takes_ids     : std_logic;

  -- Request.
  signal request_valid  : std_logic;
  signal request_accept : std_logic;
  signal hold           : std_logic;
  signal command        : command_t;
  signal has_id         : std_logic;
  signal plain          : std_logic;
  signal silent         : std_logic;
  signal request_error  : error_t;
  signal out_of_range   : std_logic;
  signal id             : std_logic_vector(id_width - 1 downto 0);
  signal address        : std_logic_vector(address_width - 1 downto 0);
  signal count          : std_logic_vector(7 downto 0);
  signal group_number   : std_logic_vector(7 downto 0);
  signal group_flags    : std_logic_vector(5 downto 0);
  signal asks           : std_logic;
  signal number         : std_logic_vector(number_bits_of(crc_bits, groups) - 1 downto 0);
  signal number_shift   : std_logic;
  signal hold_letters   : std_logic;
  signal last_word      : std_logic_vector(data_bits - 1 downto 0);
  signal store          : std_logic;
  signal store_index    : std_logic_vector(7 downto 0);
  signal store_word     : std_logic_vector(memory_width - 1 downto 0);
  signal memory_index   : std_logic_vector(7 downto 0);
  signal memory_word    : std_logic_vector(memory_width - 1 downto 0);

  -- Response ring.
  signal response_write  : std_logic;
  signal response_commit : std_logic;
  signal response_undo   : std_logic;
  signal response_room   : unsigned(response_bits - 1 downto 0);
  signal response_word   : std_logic_vector(data_bits - 1 downto 0);
  signal response_pop    : std_logic;

  -- Accesses of requests and of samples.
  signal access_request   : std_logic;
  signal access_write     : std_logic;
  signal access_more      : std_logic;
  signal access_exclusive : std_logic;
  signal access_address   : std_logic_vector(address_bits - 1 downto 0);
  signal access_data      : std_logic_vector(data_bits - 1 downto 0);
  signal access_kept      : std_logic;
  signal kept_word        : std_logic_vector(data_bits - 1 downto 0);
  signal access_granted   : std_logic;
  signal access_done      : std_logic;
  signal access_last      : std_logic;
  signal sample           : std_logic;
  signal sample_more      : std_logic;
  signal sample_address   : std_logic_vector(address_bits - 1 downto 0);
  signal sample_granted   : std_logic;
  signal sample_done      : std_logic;
  signal access_failure   : error_t;
  signal read_data        : std_logic_vector(data_bits - 1 downto 0);

  -- Groups and samples.
  signal group_is_set     : std_logic;
  signal group_request    : std_logic;
  signal group_operation  : group_operation_t;
  signal group_done       : std_logic;
  signal list_write       : std_logic;
  signal list_index       : std_logic_vector(7 downto 0);
  signal epoch            : std_logic;
  signal sample_available : std_logic;
  signal sample_word      : std_logic_vector(sample_width - 1 downto 0);
  signal sample_pop       : std_logic;

  -- Answer.
  signal answer_valid    : std_logic;
  signal answer_taken    : std_logic;
  signal answer_message  : message_t;
  signal answer_lower    : std_logic;
  signal answer_plain    : std_logic;
  signal answer_mark     : flush_mark_t;
  signal answer_has_id   : std_logic;
  signal answer_has_addr : std_logic;
  signal answer_has_pair : std_logic;
  signal answer_id       : std_logic_vector(id_width - 1 downto 0);
  signal answer_pair     : std_logic_vector(7 downto 0);
  signal answer_words    : std_logic_vector(7 downto 0);
  signal tail            : std_logic;
  signal tail_more       : unsigned(2 downto 0);
  signal tail_digit      : std_logic_vector(3 downto 0);
  signal tail_left       : unsigned(2 downto 0);
  signal tail_taken      : std_logic;

  -- Bodies and bytes to send.
  signal writer_data  : std_logic_vector(7 downto 0);
  signal writer_valid : std_logic;
  signal writer_ready : std_logic;
  signal writer_last  : std_logic;
  signal writer_plain : std_logic;
  signal writer_mark  : flush_mark_t;
  signal sent_data    : std_logic_vector(7 downto 0);
  signal sent_mark    : flush_mark_t;
  signal sent_valid   : std_logic;
  signal sent_ready   : std_logic;
  signal tx_entry     : std_logic_vector(9 downto 0);
  signal tx_in        : std_logic_vector(9 downto 0);
  signal tx_in_valid  : std_logic;
  signal tx_in_ready  : std_logic;
  signal tx_waits     : std_logic;
  signal tx_leaves    : std_logic;

  signal datalink_busy : std_logic;
  signal decoder_busy  : std_logic;
  signal writer_busy   : std_logic;
  signal sending_busy  : std_logic;
  signal packing_busy  : std_logic;
  signal is_active     : std_logic;

begin

  assert data_bits >= 8 and data_bits <= 64
    report "unity_link: data_bits is " & integer'image(data_bits) & ", expected 8 to 64"
    severity failure;

  assert address_bits >= 8 and address_bits <= 32
    report "unity_link: address_bits is " & integer'image(address_bits) & ", expected 8 to 32"
    severity failure;

  assert id_digits = 2 or id_digits = 3
    report "unity_link: id_digits is " & integer'image(id_digits) & ", expected 2 or 3"
    severity failure;

  assert (crc_bits /= 8 and crc_bits /= 16 and crc_bits /= 32)
         or (unsigned(crc_polynomial) /= 0 and shift_right(unsigned(crc_polynomial), crc_bits) = 0)
    report "unity_link: crc_polynomial is 0 or has more than the " & integer'image(crc_bits)
           & " bits of crc_bits, expected that of a CRC of so many bits, such as 00000007, 00001021 or 04C11DB7"
    severity failure;

  assert not compact or (checked_frames and digits_of(data_bits) mod 2 = 0)
    report "unity_link: compact needs checked frames and data_bits with an even number of hex digits, not "
           & integer'image(data_bits)
    severity failure;

  -- The answer to Q has four digits for each depth.
  assert rx_fifo_depth <= 32768 and tx_fifo_depth <= 32768
    report "unity_link: rx_fifo_depth is " & integer'image(rx_fifo_depth) & " and tx_fifo_depth "
           & integer'image(tx_fifo_depth) & ", expected 2 to 32768"
    severity failure;

  assert block_words <= 255
    report "unity_link: block_words is " & integer'image(block_words) & ", expected 1 to 255"
    severity failure;

  -- The answer to `Q` has two digits for the number of words, even without groups.
  assert groups <= 256 and group_words <= 255 and (groups = 0 or group_words >= 1)
    report "unity_link: groups is " & integer'image(groups) & " and group_words " & integer'image(group_words)
           & ", expected 0 to 256 and 1 to 255"
    severity failure;

  assert groups = 0 or sample_depth >= group_words + 2
    report "unity_link: sample_depth is " & integer'image(sample_depth)
           & ", which is less than one sample of the largest group takes (" & integer'image(group_words + 2) & ")"
    severity failure;

  assert checked_frames or node < 0
    report "unity_link: a node on a shared medium needs checked frames"
    severity failure;

  takes_ids     <= in_session and not no_session;
  taken_session <= session when no_session = '0' else
                   (others => '0');

  -- Received bytes.

  fifo_in <= rx_lost & rx_data;

  rx_fifo_inst : entity work.ul_fifo_sync
    generic map (
      width => 9,
      depth => rx_fifo_depth
    )
    port map (
      clk       => clk,
      rst       => rst,
      in_data   => fifo_in,
      in_valid  => rx_valid,
      in_ready  => rx_ready,
      out_data  => fifo_out,
      out_valid => fifo_out_valid,
      out_ready => fifo_out_ready,
      level     => open
    );

  -- Registered, because the FIFO's memory has a long clock-to-output delay and the logic after it is deep.
  rx_register_inst : entity work.ul_stream_register
    generic map (
      width => 9
    )
    port map (
      clk       => clk,
      rst       => rst,
      in_data   => fifo_out,
      in_valid  => fifo_out_valid,
      in_ready  => fifo_out_ready,
      out_data  => byte_in,
      out_valid => byte_valid,
      out_ready => byte_ready
    );

  with_compact_rx : if compact generate

    compact_rx_inst : entity work.ul_compact_rx
      generic map (
        id_digits      => id_digits,
        address_digits => digits_of(address_bits),
        node           => node
      )
      port map (
        clk       => clk,
        rst       => rst,
        in_data   => byte_in(7 downto 0),
        in_lost   => byte_in(8),
        in_valid  => byte_valid,
        in_ready  => byte_ready,
        out_data  => character_in(7 downto 0),
        out_lost  => character_in(8),
        out_valid => character_valid,
        out_ready => character_ready
      );

  end generate with_compact_rx;

  without_compact_rx : if not compact generate

    character_in    <= byte_in;
    character_valid <= byte_valid;
    byte_ready      <= character_ready;

  end generate without_compact_rx;

  with_datalink_rx : if checked_frames generate

    datalink_rx_inst : entity work.ul_datalink_rx
      generic map (
        crc_bits       => crc_bits,
        crc_polynomial => crc_polynomial,
        longest        => longest,
        node           => node
      )
      port map (
        clk         => clk,
        rst         => rst,
        in_data     => character_in(7 downto 0),
        in_lost     => character_in(8),
        in_valid    => character_valid,
        in_ready    => character_ready,
        session     => taken_session,
        in_session  => takes_ids,
        out_data    => body_data,
        out_valid   => body_valid,
        out_ready   => body_ready,
        out_last    => body_last,
        out_plain   => body_plain,
        out_error   => body_error,
        out_silent  => body_silent,
        out_residue => residue,
        busy        => datalink_busy
      );

  end generate with_datalink_rx;

  without_datalink_rx : if not checked_frames generate

    body_plain  <= '1';
    body_silent <= '0';
    residue     <= (others => '0');

    plain_rx_inst : entity work.ul_plain_rx
      port map (
        clk       => clk,
        rst       => rst,
        in_data   => character_in(7 downto 0),
        in_lost   => character_in(8),
        in_valid  => character_valid,
        in_ready  => character_ready,
        out_data  => body_data,
        out_valid => body_valid,
        out_ready => body_ready,
        out_last  => body_last,
        out_error => body_error,
        busy      => datalink_busy
      );

  end generate without_datalink_rx;

  -- Requests.

  request_decoder_inst : entity work.ul_request_decoder
    generic map (
      data_bits      => data_bits,
      address_bits   => address_bits,
      id_digits      => id_digits,
      crc_bits       => crc_bits,
      block_words    => block_words,
      groups         => groups,
      group_words    => group_words,
      masked_write   => masked_write,
      queue_commands => queue_commands,
      compact        => compact,
      timestamps     => timestamps,
      triggers       => triggers,
      send_immediate => send_immediate,
      half_duplex    => half_duplex
    )
    port map (
      clk                  => clk,
      rst                  => rst,
      in_data              => body_data,
      in_valid             => body_valid,
      in_ready             => body_ready,
      in_last              => body_last,
      in_plain             => body_plain,
      in_error             => body_error,
      in_silent            => body_silent,
      in_residue           => residue,
      in_session           => takes_ids,
      for_program          => for_program,
      request_valid        => request_valid,
      request_accept       => request_accept,
      hold                 => hold,
      hold_letters         => hold_letters,
      request_command      => command,
      request_has_id       => has_id,
      request_plain        => plain,
      request_silent       => silent,
      request_error        => request_error,
      request_out_of_range => out_of_range,
      request_id           => id,
      request_address      => address,
      request_count        => count,
      request_group        => group_number,
      request_flags        => group_flags,
      request_asks         => asks,
      request_number       => number,
      number_shift         => number_shift,
      request_word         => last_word,
      store                => store,
      store_index          => store_index,
      store_word           => store_word,
      busy                 => decoder_busy
    );

  request_memory_inst : entity work.ul_word_memory
    generic map (
      width => memory_width,
      depth => memory_depth
    )
    port map (
      clk         => clk,
      write       => store,
      write_index => unsigned(store_index(log2_ceil(memory_depth) - 1 downto 0)),
      write_data  => store_word,
      read_index  => unsigned(memory_index(log2_ceil(memory_depth) - 1 downto 0)),
      read_data   => memory_word
    );

  request_executor_inst : entity work.ul_request_executor
    generic map (
      data_bits      => data_bits,
      address_bits   => address_bits,
      id_digits      => id_digits,
      crc_bits       => crc_bits,
      groups         => groups,
      masked_write   => masked_write,
      queue_commands => queue_commands,
      send_immediate => send_immediate,
      room_bits      => response_bits
    )
    port map (
      clk                  => clk,
      rst                  => rst,
      request_valid        => request_valid,
      request_accept       => request_accept,
      hold                 => hold,
      hold_letters         => hold_letters,
      request_command      => command,
      request_has_id       => has_id,
      request_plain        => plain,
      request_silent       => silent,
      request_error        => request_error,
      request_out_of_range => out_of_range,
      request_id           => id,
      request_address      => address,
      request_count        => count,
      request_group        => group_number,
      request_word         => last_word,
      request_asks         => asks,
      request_number       => number,
      number_shift         => number_shift,
      session              => session,
      in_session           => in_session,
      for_program          => for_program,
      no_session           => no_session,
      memory_index         => memory_index,
      memory_word          => memory_word(data_bits - 1 downto 0),
      ring_write           => response_write,
      ring_commit          => response_commit,
      ring_rollback        => response_undo,
      ring_room            => response_room,
      access_request       => access_request,
      access_write         => access_write,
      access_more          => access_more,
      access_exclusive     => access_exclusive,
      access_address       => access_address,
      access_data          => access_data,
      access_kept          => access_kept,
      kept_word            => kept_word,
      access_granted       => access_granted,
      access_done          => access_done,
      access_last          => access_last,
      access_failure       => access_failure,
      access_read_data     => read_data,
      group_is_set         => group_is_set,
      group_request        => group_request,
      group_operation      => group_operation,
      group_done           => group_done,
      list_write           => list_write,
      list_index           => list_index,
      epoch                => epoch,
      drop_samples         => drop_samples,
      answer_valid         => answer_valid,
      answer_taken         => answer_taken,
      answer_message       => answer_message,
      answer_lower         => answer_lower,
      answer_plain         => answer_plain,
      answer_mark          => answer_mark,
      answer_has_id        => answer_has_id,
      answer_has_address   => answer_has_addr,
      answer_has_pair      => answer_has_pair,
      answer_id            => answer_id,
      answer_pair          => answer_pair,
      answer_words         => answer_words,
      tail                 => tail,
      tail_more            => tail_more,
      tail_digit           => tail_digit,
      tail_left            => tail_left,
      tail_taken           => tail_taken
    );

  response_ring_inst : entity work.ul_word_ring
    generic map (
      width => data_bits,
      depth => response_depth
    )
    port map (
      clk        => clk,
      rst        => rst,
      write      => response_write,
      write_data => read_data,
      commit     => response_commit,
      rollback   => response_undo,
      room       => response_room,
      available  => open,
      read_data  => response_word,
      pop        => response_pop
    );

  bus_master_inst : entity work.ul_bus_master
    generic map (
      data_bits    => data_bits,
      address_bits => address_bits,
      timeout      => bus_timeout,
      pipelined    => bus_pipelined
    )
    port map (
      clk               => clk,
      rst               => rst,
      request           => access_request,
      request_write     => access_write,
      request_more      => access_more,
      request_exclusive => access_exclusive,
      request_address   => access_address,
      request_data      => access_data,
      request_kept      => access_kept,
      kept_word         => kept_word,
      request_granted   => access_granted,
      request_done      => access_done,
      request_last      => access_last,
      sample            => sample,
      sample_more       => sample_more,
      sample_address    => sample_address,
      sample_granted    => sample_granted,
      sample_done       => sample_done,
      sample_strobe     => sample_strobe,
      sample_access     => sample_access,
      failure           => access_failure,
      read_data         => read_data,
      bus_request       => bus_request,
      bus_write         => bus_write,
      bus_lock          => bus_lock,
      bus_ahead         => bus_ahead,
      bus_next          => bus_next,
      bus_address       => bus_address,
      bus_write_data    => bus_write_data,
      bus_read_data     => bus_read_data,
      bus_done          => bus_done,
      bus_error         => bus_error
    );

  -- Groups.

  with_groups : if has_groups generate

    signal ring_write    : std_logic;
    signal ring_data     : std_logic_vector(sample_width - 1 downto 0);
    signal ring_commit   : std_logic;
    signal ring_rollback : std_logic;
    signal ring_room     : unsigned(room_bits - 1 downto 0);
    signal ring_reset    : std_logic;

  begin

    -- At that time no group is active and no sample is being sent.
    ring_reset <= rst or drop_samples;

    subscription_manager_inst : entity work.ul_subscription_manager
      generic map (
        data_bits                 => data_bits,
        address_bits              => address_bits,
        groups                    => groups,
        group_words               => group_words,
        clock_hz                  => clock_hz,
        base_frequency_millihertz => base_frequency_millihertz,
        timestamps                => timestamps,
        triggers                  => triggers,
        room_bits                 => room_bits
      )
      port map (
        clk              => clk,
        rst              => rst,
        trigger          => trigger(groups - 1 downto 0),
        group_request    => group_request,
        group_operation  => group_operation,
        group_done       => group_done,
        group_number     => group_number,
        group_flags      => group_flags,
        group_divisor    => number(15 downto 0),
        group_count      => count,
        group_is_set     => group_is_set,
        list_write       => list_write,
        list_index       => list_index,
        list_address     => memory_word(address_bits - 1 downto 0),
        epoch            => epoch,
        access_request   => sample,
        access_more      => sample_more,
        access_address   => sample_address,
        access_granted   => sample_granted,
        access_done      => sample_done,
        access_failure   => access_failure,
        access_read_data => read_data,
        ring_write       => ring_write,
        ring_data        => ring_data,
        ring_commit      => ring_commit,
        ring_rollback    => ring_rollback,
        ring_room        => ring_room,
        base_tick        => base_tick,
        timestamp        => timestamp
      );

    sample_ring_inst : entity work.ul_word_ring
      generic map (
        width => sample_width,
        depth => sample_depth
      )
      port map (
        clk        => clk,
        rst        => ring_reset,
        write      => ring_write,
        write_data => ring_data,
        commit     => ring_commit,
        rollback   => ring_rollback,
        room       => ring_room,
        available  => sample_available,
        read_data  => sample_word,
        pop        => sample_pop
      );

  end generate with_groups;

  without_groups : if not has_groups generate

    group_is_set     <= '0';
    group_done       <= '0';
    sample           <= '0';
    sample_more      <= '0';
    sample_address   <= (others => '0');
    sample_available <= '0';
    sample_word      <= (others => '0');

    clock_inst : entity work.ul_gateway_clock
      generic map (
        clock_hz                  => clock_hz,
        base_frequency_millihertz => base_frequency_millihertz
      )
      port map (
        clk       => clk,
        rst       => rst,
        base_tick => base_tick,
        timestamp => timestamp
      );

  end generate without_groups;

  -- Bytes to send.

  frame_writer_inst : entity work.ul_frame_writer
    generic map (
      data_bits    => data_bits,
      address_bits => address_bits,
      id_digits    => id_digits,
      q_fields     => q_answer
    )
    port map (
      clk                => clk,
      rst                => rst,
      answer_valid       => answer_valid,
      answer_taken       => answer_taken,
      answer_message     => answer_message,
      answer_lower       => answer_lower,
      answer_plain       => answer_plain,
      answer_mark        => answer_mark,
      answer_has_id      => answer_has_id,
      answer_has_address => answer_has_addr,
      answer_has_pair    => answer_has_pair,
      answer_id          => answer_id,
      answer_address     => address,
      answer_pair        => answer_pair,
      answer_words       => answer_words,
      tail               => tail,
      tail_more          => tail_more,
      tail_digit         => tail_digit,
      tail_left          => tail_left,
      tail_taken         => tail_taken,
      response_word      => response_word,
      response_pop       => response_pop,
      sample_available   => sample_available,
      sample_word        => sample_word,
      sample_pop         => sample_pop,
      epoch              => epoch,
      out_data           => writer_data,
      out_valid          => writer_valid,
      out_ready          => writer_ready,
      out_last           => writer_last,
      out_plain          => writer_plain,
      out_mark           => writer_mark,
      busy               => writer_busy
    );

  with_datalink_tx : if checked_frames generate

    datalink_tx_inst : entity work.ul_datalink_tx
      generic map (
        crc_bits       => crc_bits,
        crc_polynomial => crc_polynomial,
        node           => node
      )
      port map (
        clk        => clk,
        rst        => rst,
        in_data    => writer_data,
        in_valid   => writer_valid,
        in_ready   => writer_ready,
        in_last    => writer_last,
        in_plain   => writer_plain,
        in_mark    => writer_mark,
        session    => session,
        in_session => in_session,
        no_session => no_session,
        out_data   => sent_data,
        out_mark   => sent_mark,
        out_valid  => sent_valid,
        out_ready  => sent_ready,
        busy       => sending_busy
      );

  end generate with_datalink_tx;

  without_datalink_tx : if not checked_frames generate

    plain_tx_inst : entity work.ul_plain_tx
      port map (
        clk       => clk,
        rst       => rst,
        in_data   => writer_data,
        in_valid  => writer_valid,
        in_ready  => writer_ready,
        in_last   => writer_last,
        in_mark   => writer_mark,
        out_data  => sent_data,
        out_mark  => sent_mark,
        out_valid => sent_valid,
        out_ready => sent_ready,
        busy      => sending_busy
      );

  end generate without_datalink_tx;

  with_compact_tx : if compact generate

    signal asked : std_logic;

  begin

    -- When the compact transmitter sees the first character of a frame, the frame writer still outputs the rest of that
    -- frame, so writer_plain is that of the frame.
    asked <= session(session'high) and not no_session and not writer_plain;

    compact_tx_inst : entity work.ul_compact_tx
      generic map (
        id_digits => id_digits,
        node      => node
      )
      port map (
        clk       => clk,
        rst       => rst,
        compact   => asked,
        in_data   => sent_data,
        in_mark   => sent_mark,
        in_valid  => sent_valid,
        in_ready  => sent_ready,
        out_data  => tx_in(7 downto 0),
        out_mark  => tx_in(9 downto 8),
        out_valid => tx_in_valid,
        out_ready => tx_in_ready,
        busy      => packing_busy
      );

  end generate with_compact_tx;

  without_compact_tx : if not compact generate

    tx_in        <= sent_mark & sent_data;
    tx_in_valid  <= sent_valid;
    sent_ready   <= tx_in_ready;
    packing_busy <= '0';

  end generate without_compact_tx;

  tx_fifo_inst : entity work.ul_fifo_sync
    generic map (
      width => 10,
      depth => tx_fifo_depth
    )
    port map (
      clk       => clk,
      rst       => rst,
      in_data   => tx_in,
      in_valid  => tx_in_valid,
      in_ready  => tx_in_ready,
      out_data  => tx_entry,
      out_valid => tx_waits,
      out_ready => tx_ready,
      level     => open
    );

  tx_data   <= tx_entry(7 downto 0);
  tx_valid  <= tx_waits;
  tx_leaves <= tx_waits and tx_ready;
  is_active <= fifo_out_valid or byte_valid or character_valid or datalink_busy or decoder_busy or hold or writer_busy or sending_busy
               or packing_busy or tx_waits;
  active    <= is_active;

  with_send_immediate : if send_immediate generate

    send_immediate_inst : entity work.ul_send_immediate
      port map (
        clk    => clk,
        rst    => rst,
        left   => tx_leaves,
        mark   => tx_entry(9 downto 8),
        active => is_active,
        flush  => flush
      );

  end generate with_send_immediate;

  without_send_immediate : if not send_immediate generate

    flush <= '0';

  end generate without_send_immediate;

end architecture rtl;
