-- SPDX-License-Identifier: BSD-3-Clause
--
-- Writes the Ethernet frames that a gateway sends, byte by byte: answers to ARP requests, pings and discovery requests,
-- refusals (X0A), and datagrams of the frames from the core, each with its header.
--
-- A datagram begins as soon as a whole frame of the core is available. It includes all frames that arrive until its
-- length field is sent; later frames are gathered for the next datagram. Its UDP checksum is 0 (unused), because the
-- Ethernet frame check sequence and Unity-Link's CRC cover the content.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.unity_link_pkg.all;
  use work.ul_crc_pkg.all;
  use work.ul_ethernet_pkg.all;

entity ul_datagram_writer is
  generic (
    udp_port       : positive                      := 21_845;
    gateway_name   : string                        := "";
    fingerprint    : boolean                       := false;
    crc_bits       : positive                      := 16;
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021"
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- As in `ul_datagram_reader`.
    job          : in    job_t;
    job_plain    : in    std_logic;
    job_bank     : in    bank_t;
    job_bytes    : in    unsigned(10 downto 0);
    job_carry    : in    std_logic;
    job_done     : out   std_logic;
    echo_data    : in    std_logic_vector(7 downto 0);
    echo_valid   : in    std_logic;
    echo_taken   : out   std_logic;
    opener       : in    bank_t;
    requester    : in    bank_t;
    has_session  : in    std_logic;
    opened       : in    std_logic;
    asking_plain : in    std_logic;
    hold         : in    std_logic;
    still        : out   std_logic;
    read_at      : out   peer_address_t;
    read_data    : in    std_logic_vector(7 downto 0);
    -- As in `ul_answer_ring`.
    whole        : in    unsigned(10 downto 0);
    to_asking    : in    std_logic;
    close        : out   std_logic;
    answer_data  : in    std_logic_vector(7 downto 0);
    answer_taken : out   std_logic;
    -- Bytes of frames, for `ul_mac`.
    out_data  : out   std_logic_vector(7 downto 0);
    out_last  : out   std_logic;
    out_valid : out   std_logic;
    out_ready : in    std_logic
  );
end entity ul_datagram_writer;

architecture rtl of ul_datagram_writer is

  constant check_digits : positive := crc_bits / 4;
  -- Bytes of: the IP and UDP headers, the text of our header up to its count, that header with CR LF (plain) and with
  -- CRC and LF (checked), and X0A in both forms.
  constant header_bytes    : positive := 28;
  constant text_bytes      : positive := 17;
  constant header_plain    : positive := text_bytes + 2;
  constant header_checked  : positive := text_bytes + check_digits + 1;
  constant refusal_plain   : positive := 5;
  constant refusal_checked : positive := 3 + check_digits + 1;

  type state_t is (idle, head, text, ends, payload);

  constant port_bits : std_logic_vector(15 downto 0) := std_logic_vector(to_unsigned(udp_port, 16));

  -- Ones' complement sum of the constant words of an IP header: version, flags, time to live and protocol.
  function fixed_words (protocol : natural) return unsigned is
  begin

    return to_unsigned(16#4500# + 16#4000# + 16#4000# + protocol, 16);

  end function fixed_words;

  -- The last 16 bytes of a discovery answer, selected by the lower half of a byte's place: features, then the name.
  function named return std_logic_vector is

    variable bits : std_logic_vector(127 downto 0) := (others => '0');
    variable code : natural range 0 to 255;

  begin

    bits(120) := to_std_logic(fingerprint);

    for letter in 1 to gateway_name'length loop

      code := character'pos(gateway_name(letter));

      bits(127 - 8 * letter downto 120 - 8 * letter) := std_logic_vector(to_unsigned(code, 8));

    end loop;

    return bits;

  end function named;

  constant facts : std_logic_vector(127 downto 0) := named;

  signal state   : state_t;
  signal phase   : std_logic;
  signal place   : unsigned(5 downto 0);
  signal kind    : job_t;
  signal bank    : bank_t;
  signal plain   : std_logic;
  signal offered : std_logic;
  -- The header of the refusal is sent; X0A follows.
  signal refusal  : std_logic;
  signal refuses  : std_logic;
  signal total    : unsigned(10 downto 0);
  signal overhead : natural range 0 to 127;
  signal left     : unsigned(10 downto 0);
  signal count    : unsigned(31 downto 0);
  signal crc      : std_logic_vector(crc_bits - 1 downto 0);
  signal covered  : std_logic;
  signal sum      : unsigned(15 downto 0);
  signal carry    : std_logic;
  signal free     : std_logic;
  signal valid    : std_logic;
  signal out_byte : std_logic_vector(7 downto 0);
  signal produced : std_logic;
  signal finishes : std_logic;

begin

  out_data  <= out_byte;
  out_valid <= valid;
  -- The output register is free for the next byte.
  free       <= not valid or out_ready;
  produced   <= free and phase when state = head or state = text or state = ends else
                '0';
  still      <= to_std_logic(state = idle) and not valid;
  close      <= to_std_logic(state = head and kind = job_none and place = 16) and not phase;
  refuses    <= to_std_logic(kind = job_refuse);
  echo_taken <= free and echo_valid when state = payload and kind = job_echo else
                '0';

  answer_taken <= free when state = payload and kind = job_none else
                  '0';

  -- Bytes of a datagram besides the frames of the core, from the IP header on.
  overhead <= header_bytes + header_plain when plain = '1' and refuses = '0' else
              header_bytes + find_bytes when kind = job_find else
              header_bytes + header_checked when refuses = '0' else
              header_bytes + header_plain + refusal_plain when plain = '1' else
              header_bytes + header_checked + refusal_checked;

  addresses : process (state, place, kind, bank, offered) is

    variable slot   : unsigned(4 downto 0);
    variable is_own : boolean;

  begin

    slot   := place(4 downto 0);
    is_own := false;
    if state = text then
      slot   := resize(place + 15, 5);
      is_own := offered = '1';
      if kind = job_find then
        slot   := resize(place - 2, 5);
        is_own := true;
      end if;
    elsif place >= 6 and place <= 15 then
      slot   := resize(place - 6, 5);
      is_own := true;
    elsif place >= 16 and place <= 19 then
      slot := resize(place - 10, 5);
    elsif kind = job_arp then
      if place >= 22 and place <= 31 then
        slot   := resize(place - 22, 5);
        is_own := true;
      end if;
    elsif place >= 26 and place <= 29 then
      slot   := resize(place - 20, 5);
      is_own := true;
    elsif (place >= 30 and place <= 33) or (kind = job_echo and place >= 36) then
      slot := resize(place - 24, 5);
    elsif place >= 36 then
      slot := resize(place - 26, 5);
    end if;
    read_at <= bank & std_logic_vector(slot);
    if is_own then
      read_at <= own_bank & std_logic_vector(slot);
    end if;

  end process addresses;

  main : process (clk) is

    variable index : natural range 0 to 63;
    variable term  : unsigned(16 downto 0);
    variable adds  : std_logic;
    variable last  : std_logic;

  begin

    if rising_edge(clk) then
      index    := to_integer(place);
      adds     := '0';
      last     := '0';
      term     := (others => '0');
      covered  <= '0';
      job_done <= '0';
      phase    <= not phase or not produced;
      if out_ready = '1' then
        valid <= '0';
      end if;
      if produced = '1' then
        valid <= '1';
        place <= place + 1;
      end if;
      if covered = '1' then
        crc <= crc_after(crc, out_byte, crc_polynomial);
      end if;

      case state is

        when idle =>
          place   <= (others => '0');
          phase   <= '0';
          refusal <= '0';
          carry   <= '0';
          sum     <= fixed_words(17);
          if job = job_echo then
            sum <= fixed_words(1);
          end if;
          if job /= job_none and job_done = '0' then
            kind    <= job;
            bank    <= job_bank;
            plain   <= job_plain;
            offered <= '0';
            state   <= head;
          elsif whole /= 0 and job = job_none and hold = '0' then
            kind    <= job_none;
            bank    <= opener;
            plain   <= to_asking and asking_plain;
            offered <= to_asking;
            state   <= head;
            if to_asking = '1' then
              bank <= requester;
            else
              count <= count + 1;
              if count = x"FFFFFFFF" then
                count <= to_unsigned(1, count'length);
              end if;
            end if;
          end if;

        when head =>
          if phase = '0' and kind /= job_arp then
            if place = 16 then
              left  <= whole;
              total <= whole + overhead;
              if refuses = '1' or kind = job_find then
                total <= to_unsigned(overhead, total'length);
              elsif kind = job_echo then
                left  <= job_bytes - header_bytes;
                total <= job_bytes;
              end if;
            elsif place = 17 then
              adds := '1';
              term := resize(total, 17);
            elsif place = 18 then
              total <= total - 20;
            end if;
          end if;
          -- Add both IP addresses to the checksum while bytes are sent that need no memory, then add the carries.
          if produced = '1' and place >= 12 and place <= 21 then
            adds := '1';
            if place <= 19 then
              term := resize(unsigned(read_data), 17);
              if place(0) = '0' then
                term := shift_left(term, 8);
              end if;
            end if;
          end if;

          out_byte <= x"00";

          case index is

            when 0 to 11 =>
              out_byte <= read_data;

            when 12 =>
              out_byte <= x"08";

            when others =>
              if kind = job_arp then

                case index is

                  when 13 =>
                    out_byte <= x"06";

                  when 15 =>
                    out_byte <= x"01";

                  when 16 =>
                    out_byte <= x"08";

                  when 18 =>
                    out_byte <= x"06";

                  when 19 =>
                    out_byte <= x"04";

                  when 21 =>
                    out_byte <= x"02";

                  when 22 to 41 =>
                    out_byte <= read_data;

                  when others =>
                    null;

                end case;

              else

                case index is

                  when 14 =>
                    out_byte <= x"45";

                  when 16 | 38 =>
                    out_byte(2 downto 0) <= std_logic_vector(total(10 downto 8));
                    if index = 38 and kind = job_echo then
                      out_byte <= read_data;
                    end if;

                  when 17 | 39 =>
                    out_byte <= std_logic_vector(total(7 downto 0));
                    if index = 39 and kind = job_echo then
                      out_byte <= read_data;
                    end if;

                  when 20 | 22 =>
                    out_byte <= x"40";

                  when 23 =>
                    out_byte <= x"11";
                    if kind = job_echo then
                      out_byte <= x"01";
                    end if;

                  when 24 =>
                    out_byte <= not std_logic_vector(sum(15 downto 8));

                  when 25 =>
                    out_byte <= not std_logic_vector(sum(7 downto 0));

                  when 26 to 33 =>
                    out_byte <= read_data;

                  when 34 | 35 =>
                    if kind /= job_echo then
                      out_byte <= octet(port_bits, index - 34);
                    end if;

                  when 36 =>
                    out_byte <= read_data;
                    if kind = job_echo then
                      out_byte <= std_logic_vector(unsigned(read_data) + unsigned'(0 => job_carry));
                    end if;

                  when 37 =>
                    out_byte <= read_data;

                  when 40 | 41 =>
                    if kind = job_echo then
                      out_byte <= read_data;
                    end if;

                  when others =>
                    null;

                end case;

              end if;

          end case;

          if produced = '1' and place = 41 then
            place <= (others => '0');
            crc   <= (others => '0');
            state <= text;
            if kind = job_echo then
              state <= payload;
            end if;
            last := to_std_logic(kind = job_arp or (kind = job_echo and left = 0));
          end if;

        when text =>
          if kind = job_find then
            out_byte <= read_data;
            if place(4) = '1' then
              out_byte <= octet(facts, to_integer(place(3 downto 0)));
              if place = 16 then
                out_byte(1) <= has_session;
              end if;
            end if;
          elsif refusal = '1' then
            out_byte <= x"30";
            if place = 0 then
              out_byte <= x"58";
            elsif place = 2 then
              out_byte <= x"41";
            end if;
          elsif place = 0 then
            out_byte <= x"55";
          elsif place <= 8 then
            out_byte <= hex_character(read_data(3 downto 0));
          elsif offered = '1' or refuses = '1' then
            out_byte <= x"30";
          else
            out_byte <= hex_character(std_logic_vector(count(31 downto 28)));
          end if;
          if produced = '1' and kind = job_find then
            last := to_std_logic(place = find_bytes - 1);
          elsif produced = '1' then
            covered <= '1';
            if place > 8 then
              count <= rotate_left(count, 4);
            end if;
            if place = text_bytes - 1 or (refusal = '1' and place = 2) then
              place <= (others => '0');
              state <= ends;
            end if;
          end if;

        when ends =>
          if plain = '1' and place = 0 then
            out_byte <= character_cr;
          elsif plain = '1' or place = check_digits then
            out_byte <= character_lf;
          else
            out_byte <= hex_character(crc(crc'high downto crc'high - 3));
          end if;
          if produced = '1' then
            crc <= crc(crc'high - 4 downto 0) & "0000";
            if (plain = '1' and place = 1) or (plain = '0' and place = check_digits) then
              place <= (others => '0');
              state <= payload;
              if refuses = '1' and refusal = '0' then
                refusal <= '1';
                crc     <= (others => '0');
                state   <= text;
              end if;
              last := refuses and refusal;
            end if;
          end if;

        when payload =>
          if free = '1' and (kind = job_none or echo_valid = '1') then
            valid    <= '1';
            out_byte <= answer_data;
            if kind = job_echo then
              out_byte <= echo_data;
            end if;
            left <= left - 1;
            last := to_std_logic(left = 1);
          end if;

      end case;

      if adds = '1' then
        term  := ('0' & sum) + term + unsigned'(0 => carry);
        sum   <= term(15 downto 0);
        carry <= term(16);
      end if;
      if produced = '1' or state = payload then
        if free = '1' then
          out_last <= last;
        end if;
      end if;
      if last = '1' then
        state    <= idle;
        job_done <= to_std_logic(kind /= job_none);
      end if;
      -- A byte stays unchanged until it is accepted.
      if free = '0' then
        out_byte <= out_byte;
      end if;

      if opened = '1' then
        count <= (others => '0');
      end if;

      if rst = '1' then
        state    <= idle;
        phase    <= '0';
        place    <= (others => '0');
        kind     <= job_none;
        bank     <= "00";
        plain    <= '0';
        offered  <= '0';
        refusal  <= '0';
        total    <= (others => '0');
        left     <= (others => '0');
        count    <= (others => '0');
        crc      <= (others => '0');
        covered  <= '0';
        sum      <= (others => '0');
        carry    <= '0';
        valid    <= '0';
        out_byte <= (others => '0');
        job_done <= '0';
        out_last <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
