-- SPDX-License-Identifier: BSD-3-Clause
--
-- Reads the records of `ul_network_rx` and decides on each: it answers ARP requests, pings and discovery requests, and
-- accepts or rejects datagrams by the rules of docs/protocol.md ("Datagrams"). The frames of accepted datagrams go to
-- the core.
--
-- The data of the hosts is in a memory of four banks. Three of them have the same layout: a MAC address (slots 0 to 5),
-- an IP address (6 to 9), a port (10, 11), the digits of a session (16 to 23) and of a count (24 to 31). One bank
-- belongs to the opener, the host that opened the session, and has the newest count accepted. One belongs to the
-- requester, the host that last sent a request without a session. One belongs to the candidate, the sender of the
-- present datagram; for a ping, slots 10 to 17 contain fields of the ping instead. When a datagram is accepted, the
-- banks of the opener and the candidate change roles, so that no bytes are copied. The last bank has the gateway's own
-- addresses, written after the reset, and the digits of the session on offer. Each byte is compared with the opener's
-- byte and with the gateway's own byte when it arrives, so all results are known after the last byte.
--
-- A broadcast datagram can only be a discovery request (docs/protocol.md, "Finding boards"): none of its bytes reach
-- the core. It may set another IP address.
--
-- A frame is parsed while it arrives, but has effects only after it is committed. A change of the host to which answers
-- go also waits until the core has answered all earlier requests: until `active` has been '0' for `rest` cycles. If
-- samples keep `active` at '1', the wait ends after `patience` cycles, in which the core answers every request.
--
-- The frames of a datagram without a header go to the core as well, with `asking` = '1' to mark that they have no
-- session. So do the frames of a bare `K` under the session on offer: its characters pass while they are `K` and the
-- digits of its CRC. The first other character begins a field of `K`: the offer is accepted before this character
-- passes, and so before the core has the whole frame.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.unity_link_pkg.all;
  use work.ul_crc_pkg.all;
  use work.ul_ethernet_pkg.all;

entity ul_datagram_reader is
  generic (
    mac_address    : std_logic_vector(47 downto 0) := x"02554C000001";
    ip_address     : std_logic_vector(31 downto 0) := x"C0A80164";
    build_id       : std_logic_vector(31 downto 0) := x"00000000";
    crc_bits       : positive                      := 16;
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021"
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Records from `ul_record_ring`.
    in_data  : in    std_logic_vector(7 downto 0);
    in_valid : in    std_logic;
    in_ready : out   std_logic;
    trial    : in    std_logic;
    undone   : in    std_logic;
    done     : out   std_logic;
    -- Frames for the core.
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    -- Memory of the hosts, addressed by bank and slot.
    peer_write : out   std_logic;
    peer_at    : out   peer_address_t;
    peer_data  : out   std_logic_vector(7 downto 0);
    read_at    : out   peer_address_t;
    read_data  : in    std_logic_vector(7 downto 0);
    -- Banks of the opener, and of the requester.
    opener      : out   bank_t;
    requester   : out   bank_t;
    has_session : out   std_logic;
    -- '1' for one cycle when a session begins.
    opened : out   std_logic;
    -- The bytes to the core are the requester's, and so are the answers. asking_plain: its first frame was plain, so
    -- the answers are plain too.
    asking       : out   std_logic;
    asking_plain : out   std_logic;
    -- Datagram to send besides the answers of the core. `job_done` ends the job; `job_bank` has the destination.
    job       : out   job_t;
    job_plain : out   std_logic;
    job_bank  : out   bank_t;
    -- Number of bytes of the ping to answer, with its IP header, and the carry of its checksum.
    job_bytes : out   unsigned(10 downto 0);
    job_carry : out   std_logic;
    job_done  : in    std_logic;
    -- `ul_datagram_writer` reads a byte of the ping from the ring.
    echo_taken : in    std_logic;
    -- Bytes are being sent, or are in the core.
    active : in    std_logic;
    -- hold: no transmission may begin except for a job. still: no transmission is in progress.
    hold  : out   std_logic;
    still : in    std_logic;
    -- A number that never repeats, for new sessions.
    cycles : in    std_logic_vector(31 downto 0)
  );
end entity ul_datagram_reader;

architecture rtl of ul_datagram_reader is

  constant check_digits : positive := crc_bits / 4;
  -- rest: cycles without activity after which the core has certainly answered all requests. patience: longest wait for
  -- that.
  constant rest     : positive := 15;
  constant patience : positive := 2 ** 17 - 1;

  -- Initial contents of both halves of the own bank.
  constant own : std_logic_vector(127 downto 0) := mac_address & ip_address & build_id & find_mark;

  type state_t is (
    own_slots, head, find, first, digit, check, line_end, decide, peek, refuse, quiet, weigh, offer, pass, end_line,
    answer, drain
  );

  -- Reason for the wait in the state `quiet`.

  type purpose_t is (to_take, to_open, to_ask);

  signal state     : state_t;
  signal purpose   : purpose_t;
  signal phase     : natural range 0 to 2;
  signal place     : unsigned(5 downto 0);
  signal left      : unsigned(10 downto 0);
  signal last_one  : std_logic;
  signal none_left : std_logic;
  signal is_arp    : std_logic;
  signal is_icmp   : std_logic;
  signal is_find   : std_logic;
  -- All bytes so far match: the discovery request is for this gateway alone (is_mine), or for all gateways (is_all).
  signal is_mine : std_logic;
  signal is_all  : std_logic;
  -- Carry of the ping's checksum into its next byte.
  signal wrap : std_logic;
  signal was  : std_logic_vector(7 downto 0);

  signal candidate    : bank_t;
  signal opener_i     : bank_t;
  signal requester_i  : bank_t;
  signal in_session   : std_logic;
  signal has_offer    : std_logic;
  signal asking_i     : std_logic;
  signal form_known   : std_logic;
  signal same_host    : std_logic;
  signal same_session : std_logic;
  signal on_offer     : std_logic;
  signal turned       : std_logic;
  signal differs      : std_logic;
  signal greater      : std_logic;
  signal no_count     : std_logic;
  signal malformed    : std_logic;
  signal is_plain     : std_logic;
  signal headless     : std_logic;
  signal crc          : std_logic_vector(crc_bits - 1 downto 0);
  signal rested       : natural range 0 to rest;
  signal waited       : natural range 0 to patience;

  signal numbers    : std_logic_vector(31 downto 0);
  signal line_start : std_logic;
  signal ended      : std_logic;
  signal is_end     : std_logic;
  signal is_match   : std_logic;
  signal is_bare    : std_logic;
  signal bare       : std_logic;
  signal other      : std_logic;
  signal take       : std_logic;
  signal passes     : std_logic;

  function slot_of (number : unsigned(5 downto 0)) return unsigned is
  begin

    if number <= 5 or number >= 48 then
      return number(4 downto 0);
    elsif number <= 12 then
      return resize(number - 3, 5);
    elsif number <= 24 then
      return resize(number - 7, 5);
    else
      return resize(number + 5, 5);
    end if;

  end function slot_of;

begin

  opener      <= opener_i;
  requester   <= requester_i;
  has_session <= in_session;
  asking      <= asking_i;
  job_plain   <= is_plain;
  job_carry   <= wrap;
  none_left   <= '1' when left = 0 else
                 '0';
  last_one    <= '1' when left = 1 else
                 '0';
  is_end      <= to_std_logic(in_data = character_lf or in_data = character_cr);
  is_match    <= is_hex(in_data) and to_std_logic(hex_value(in_data) = crc(crc'high downto crc'high - 3));
  -- At place 0 is the letter K. A character is compared in one cycle and passes in a later one, which keeps the paths
  -- short.
  is_bare <= to_std_logic(place = 0) or (is_match and to_std_logic(place <= check_digits));

  passes    <= in_valid and not none_left when state = pass else
               bare and to_std_logic(phase = 2) when state = weigh else
               '0';
  out_valid <= '1' when passes = '1' or state = end_line else
               '0';
  out_data  <= character_lf when state = end_line else
               in_data;

  with state select take <=
    in_valid and to_std_logic(phase = 2) when head | find | digit | check,
    in_valid and (is_end or to_std_logic(in_data = x"55")) and not none_left when first,
    in_valid and is_end and not none_left and not trial when peek,
    in_valid and not none_left when line_end,
    passes and out_ready when pass | weigh,
    in_valid and not none_left when drain,
    '0' when others;

  in_ready <= take or echo_taken;

  -- Read the opener's byte first, then the gateway's own byte.
  read_at(4 downto 0) <= std_logic_vector(slot_of(place));
  read_at(6 downto 5) <= opener_i when phase = 0 else
                         own_bank;

  main : process (clk) is

    variable sum    : unsigned(8 downto 0);
    variable nibble : std_logic_vector(3 downto 0);
    variable is_own : std_logic;

    procedure spoil is
    begin

      malformed <= '1';
      state     <= decide;

    end procedure spoil;

  begin

    if rising_edge(clk) then
      peer_write <= '0';
      done       <= '0';
      opened     <= '0';
      peer_at    <= candidate & std_logic_vector(slot_of(place));
      peer_data  <= in_data;
      nibble     := hex_value(in_data);
      is_own     := to_std_logic(read_data = in_data);

      -- `left` counts the bytes of the record's payload.
      if take = '1' and state /= head then
        left <= left - 1;
      end if;
      if echo_taken = '1' then
        left <= left - 1;
      end if;

      if phase /= 2 then
        phase <= phase + 1;
      elsif take = '1' or (state /= head and state /= find and state /= digit and state /= check) then
        phase <= 0;
      end if;
      bare  <= in_valid and not none_left and not is_end and is_bare;
      other <= in_valid and not none_left and not is_end and not is_bare;

      was <= read_data;
      if phase = 2 then
        was <= was;
      end if;

      if active = '1' or (state /= quiet) then
        rested <= 0;
      elsif rested /= rest then
        rested <= rested + 1;
      end if;
      if state /= quiet then
        waited <= 0;
      elsif waited /= patience then
        waited <= waited + 1;
      end if;

      case state is

        when own_slots =>
          peer_write <= '1';
          peer_at    <= own_bank & std_logic_vector(place(4 downto 0));
          peer_data  <= octet(own, to_integer(place(3 downto 0)));
          place      <= place + 1;
          if place = 31 then
            place <= (others => '0');
            state <= head;
          end if;

        when head =>
          if take = '1' then
            place      <= place + 1;
            peer_write <= '1';
            if place <= 5 or (place >= 9 and place <= 12) or place = 17 or place = 18 then
              same_host <= same_host and to_std_logic(was = in_data);
            end if;
            if place >= 13 and place <= 16 then
              peer_write <= '0';
              malformed  <= malformed or not (is_own or is_find);
            end if;

            case to_integer(place) is

              when 6 =>
                peer_write        <= '0';
                left(10 downto 8) <= unsigned(in_data(2 downto 0));

              when 7 =>
                peer_write       <= '0';
                left(7 downto 0) <= unsigned(in_data);

              when 8 =>
                peer_write <= '0';
                is_arp     <= in_data(0);
                is_icmp    <= in_data(1);
                is_find    <= in_data(2);
                job_bytes  <= left;
                left       <= left - 28;

              when 16 =>
                if is_arp = '1' then
                  left  <= (others => '0');
                  state <= decide;
                end if;

              -- The reply differs from the ping by -0800 in its first word, so its checksum differs by +0800.
              when 19 =>
                sum       := resize(unsigned(in_data), 9) + 8;
                peer_data <= std_logic_vector(sum(7 downto 0));
                wrap      <= sum(8);

              when 20 =>
                sum       := resize(unsigned(in_data), 9) + unsigned'(0 => wrap);
                peer_data <= std_logic_vector(sum(7 downto 0));
                wrap      <= sum(8);

              when 24 =>
                state <= first;
                if is_icmp = '1' then
                  state <= decide;
                elsif is_find = '1' then
                  state <= find;
                  if left < find_bytes then
                    spoil;
                  end if;
                end if;

              when others =>
                null;

            end case;

          end if;

        when find =>
          if take = '1' then
            place <= place + 1;
            if place <= 26 then
              malformed <= malformed or not is_own;
            elsif place <= 32 then
              is_mine <= is_mine and is_own;
              -- A group address (multicast or broadcast).
              if place = 27 then
                is_all <= in_data(0);
              elsif place = 32 then
                state <= decide;
              end if;
            else
              peer_write <= '1';
              peer_at    <= own_bank & std_logic_vector(slot_of(place));
              if place = 36 then
                job   <= job_find;
                state <= answer;
              end if;
            end if;
          end if;

        when first =>
          place <= to_unsigned(48, place'length);
          crc   <= crc_after((crc'range => '0'), x"55", crc_polynomial);
          if none_left = '1' then
            spoil;
          elsif in_valid = '1' and is_end = '0' then
            phase <= 0;
            if in_data = x"55" then
              state <= digit;
            else
              headless <= '1';
              state    <= decide;
            end if;
          end if;

        when digit =>
          if none_left = '1' then
            spoil;
          elsif take = '1' then
            peer_write <= '1';
            peer_data  <= x"0" & nibble;
            place      <= place + 1;
            crc        <= crc_after(crc, in_data, crc_polynomial);
            if is_hex(in_data) = '0' then
              spoil;
            end if;
            if place(3) = '0' then
              same_session <= same_session and to_std_logic(was(3 downto 0) = nibble);
              on_offer     <= on_offer and to_std_logic(read_data(3 downto 0) = nibble);
            else
              no_count <= no_count and to_std_logic(nibble = x"0");
              -- Serial number arithmetic: the highest bit is the half of the circle of each count, the lower bits give
              -- the order within a half.
              if place(2 downto 0) = 0 then
                turned  <= nibble(3) xor was(3);
                differs <= to_std_logic(nibble(2 downto 0) /= was(2 downto 0));
                greater <= to_std_logic(unsigned(nibble(2 downto 0)) > unsigned(was(2 downto 0)));
              elsif differs = '0' then
                differs <= to_std_logic(nibble /= was(3 downto 0));
                greater <= to_std_logic(unsigned(nibble) > unsigned(was(3 downto 0)));
              end if;
            end if;
            if place = 63 then
              place <= (others => '0');
              state <= check;
            end if;
          end if;

        when check =>
          if none_left = '1' then
            spoil;
          elsif take = '1' then
            place <= place + 1;
            crc   <= crc(crc'high - 4 downto 0) & "0000";
            if in_data = character_cr and place = 0 then
              is_plain <= '1';
              state    <= decide;
            elsif is_match = '0' then
              spoil;
            elsif place = check_digits - 1 then
              state <= line_end;
            end if;
          end if;

        when line_end =>
          if none_left = '1' then
            spoil;
          elsif in_valid = '1' then
            state <= decide;
            if in_data /= character_lf then
              malformed <= '1';
            end if;
          end if;

        when decide =>
          line_start <= '1';
          ended      <= '1';
          purpose    <= to_take;
          job_bank   <= candidate;
          if trial = '0' then
            state <= drain;
            if malformed = '1' then
              state <= drain;
            elsif is_arp = '1' then
              job   <= job_arp;
              state <= answer;
            elsif is_icmp = '1' then
              job   <= job_echo;
              state <= answer;
            elsif is_find = '1' then
              if is_mine = '1' then
                state <= find;
              elsif is_all = '1' then
                job   <= job_find;
                state <= answer;
              end if;
            elsif headless = '1' then
              purpose <= to_ask;
              state   <= quiet;
            elsif no_count = '1' then
              state <= drain;
            elsif (in_session and same_session and same_host) = '1' then
              if (differs and (greater xor turned)) = '1' then
                candidate <= opener_i;
                opener_i  <= candidate;
                state     <= pass;
                if asking_i = '1' then
                  state <= quiet;
                end if;
              end if;
            elsif (has_offer and on_offer) = '1' then
              state <= peek;
            else
              state <= refuse;
            end if;
          end if;

        when peek =>
          place <= (others => '0');
          crc   <= crc_after((crc'range => '0'), x"4B", crc_polynomial);
          if none_left = '1' then
            state <= refuse;
          elsif in_valid = '1' and is_end = '0' then
            state <= refuse;
            if in_data = x"4B" then
              purpose <= to_open;
              state   <= quiet;
            end if;
          end if;

        when refuse =>
          job      <= job_refuse;
          job_bank <= candidate;
          state    <= answer;

        when quiet =>
          if still = '1' and (rested = rest or waited = patience) then
            asking_i <= '0';
            state    <= pass;
            if purpose /= to_take then
              candidate    <= requester_i;
              requester_i  <= candidate;
              asking_i     <= '1';
              asking_plain <= '0';
              form_known   <= '0';
              if purpose = to_open then
                state <= weigh;
              elsif has_offer = '0' then
                numbers <= cycles(31 downto 1) & '1';
                place   <= to_unsigned(48, place'length);
                state   <= offer;
              end if;
            end if;
          end if;

        when weigh =>
          if take = '1' then
            place      <= place + 1;
            line_start <= '0';
            ended      <= '0';
            if place /= 0 then
              crc <= crc(crc'high - 4 downto 0) & "0000";
            end if;
          elsif none_left = '1' or (in_valid and is_end) = '1' then
            headless <= '1';
            state    <= pass;
          elsif phase = 2 and (other and still) = '1' then
            -- Send a refusal to the former opener.
            candidate   <= opener_i;
            opener_i    <= requester_i;
            requester_i <= candidate;
            asking_i    <= '0';
            has_offer   <= '0';
            in_session  <= '1';
            opened      <= '1';
            state       <= pass;
            if in_session = '1' then
              job      <= job_refuse;
              job_bank <= opener_i;
              is_plain <= '0';
              state    <= answer;
            end if;
          end if;

        when offer =>
          has_offer  <= '1';
          numbers    <= numbers(27 downto 0) & "0000";
          peer_write <= '1';
          peer_at    <= own_bank & std_logic_vector(slot_of(place));
          peer_data  <= x"0" & numbers(31 downto 28);
          place      <= place + 1;
          if place = 55 then
            state <= pass;
          end if;

        when pass =>
          if take = '1' then
            line_start <= is_end;
            ended      <= to_std_logic(in_data = character_lf);
            if (headless and is_end and not line_start and not form_known) = '1' then
              form_known   <= '1';
              asking_plain <= to_std_logic(in_data = character_cr);
            end if;
          elsif none_left = '1' then
            state <= end_line;
            if ended = '1' then
              state <= drain;
            end if;
          end if;

        when end_line =>
          if out_ready = '1' then
            ended <= '1';
            state <= pass;
          end if;

        when answer =>
          if job_done = '1' then
            job   <= job_none;
            state <= drain;
            if purpose = to_open then
              state <= pass;
            end if;
          end if;

        when drain =>
          job <= job_none;
          if none_left = '1' then
            done  <= '1';
            state <= head;
          end if;

      end case;

      if (state = drain and none_left = '1') or (undone = '1' and state /= own_slots) or rst = '1' then
        state        <= head;
        phase        <= 0;
        place        <= (others => '0');
        is_arp       <= '0';
        is_icmp      <= '0';
        is_find      <= '0';
        is_mine      <= '1';
        is_all       <= '0';
        wrap         <= '0';
        same_host    <= '1';
        same_session <= '1';
        on_offer     <= '1';
        no_count     <= '1';
        malformed    <= '0';
        headless     <= '0';
        is_plain     <= '0';
        purpose      <= to_take;
      end if;

      if rst = '1' then
        state        <= own_slots;
        candidate    <= "00";
        opener_i     <= "01";
        requester_i  <= "10";
        left         <= (others => '0');
        was          <= (others => '0');
        bare         <= '0';
        other        <= '0';
        in_session   <= '0';
        has_offer    <= '0';
        asking_i     <= '0';
        asking_plain <= '0';
        form_known   <= '0';
        turned       <= '0';
        differs      <= '0';
        greater      <= '0';
        crc          <= (others => '0');
        rested       <= 0;
        waited       <= 0;
        numbers      <= (others => '0');
        line_start   <= '1';
        ended        <= '1';
        job          <= job_none;
        job_bank     <= "00";
        job_bytes    <= (others => '0');
        peer_write   <= '0';
        peer_at      <= (others => '0');
        peer_data    <= (others => '0');
        done         <= '0';
        opened       <= '0';
      end if;
    end if;

  end process main;

  hold <= '1' when state = weigh or (state = quiet and waited = patience) else
          '0';

end architecture rtl;
