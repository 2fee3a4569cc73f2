-- SPDX-License-Identifier: BSD-3-Clause
--
-- Filters the frames of a MAC for this gateway: ARP requests, pings (ICMP echo requests), and UDP datagrams for its
-- port, broadcasts included. All other frames are dropped without a trace: those for other stations and other
-- multicasts, VLAN tags, other protocols and ports, IP fragments and options, frames shorter than their length fields,
-- wrong IP header checksums, and frames with errors.
--
-- An accepted frame is written as a record: MAC address (6 bytes), length of the IP datagram (2), kind (1: bit 0 ARP,
-- bit 1 ICMP, bit 2 UDP broadcast), IP address of the sender (4), IP address asked for or sent to (4); except for ARP,
-- the 8 bytes of the ICMP or UDP header and the payload follow. Bytes are written as they arrive: `commit` accepts the
-- record after a frame without errors, `rollback` discards it.
--
-- The UDP checksum is not checked, because the Ethernet frame check sequence covers it.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_ethernet_pkg.all;
  use work.unity_link_pkg.all;

entity ul_network_rx is
  generic (
    -- 48 bits: MAC address of this gateway.
    mac_address : std_logic_vector(47 downto 0) := x"02554C000001";
    -- 1 to 65535: UDP port.
    udp_port : positive := 21_845
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- A byte of a frame, or its status at the end, as from `ul_mac`; each is accepted at once.
    in_data  : in    std_logic_vector(7 downto 0);
    in_end   : in    std_logic;
    in_valid : in    std_logic;
    -- The record.
    write      : out   std_logic;
    write_data : out   std_logic_vector(7 downto 0);
    commit     : out   std_logic;
    rollback   : out   std_logic;
    -- The ring has no space for another byte.
    full : in    std_logic;
    -- '1' for one cycle: an error-free frame for this gateway was dropped because the ring was full.
    dropped : out   std_logic
  );
end entity ul_network_rx;

architecture rtl of ul_network_rx is

  constant header : positive := 42;

  -- Place of the arriving byte in the frame, at most `header`.
  signal place : unsigned(5 downto 0);
  -- wanted: no byte so far excludes that the frame is for this gateway. to_me, to_all: the destination so far is this
  -- gateway, or broadcast.
  signal wanted  : std_logic;
  signal to_me   : std_logic;
  signal to_all  : std_logic;
  signal is_arp  : std_logic;
  signal is_icmp : std_logic;
  -- remaining: bytes of the IP datagram after the present one. udp_bytes: length of the UDP datagram.
  signal remaining : unsigned(10 downto 0);
  signal udp_bytes : unsigned(10 downto 0);
  signal complete  : std_logic;
  signal overflow  : std_logic;
  -- counting: the byte comes after the IP length field. summing: the byte belongs to the IP header.
  signal counting : std_logic;
  signal summing  : std_logic;
  -- Ones' complement sum of the IP header, one byte per cycle: sum is the half to which the next byte is added,
  -- sum_last the other half, and carry the carry of the last addition.
  signal sum      : unsigned(7 downto 0);
  signal sum_last : unsigned(7 downto 0);
  signal carry    : std_logic;

  constant port_bits : std_logic_vector(15 downto 0) := std_logic_vector(to_unsigned(udp_port, 16));

begin

  main : process (clk) is

    variable index  : natural range 0 to 63;
    variable keep   : std_logic;
    variable is_udp : std_logic;
    variable total  : unsigned(8 downto 0);

    procedure demand (condition : boolean) is
    begin

      if not condition then
        wanted <= '0';
      end if;

    end procedure demand;

  begin

    if rising_edge(clk) then
      index      := to_integer(place);
      is_udp     := not is_arp and not is_icmp;
      keep       := '0';
      write      <= '0';
      commit     <= '0';
      rollback   <= '0';
      dropped    <= '0';
      write_data <= in_data;

      if (in_valid and not in_end) = '1' then
        if index /= header then
          place <= place + 1;
        end if;

        case index is

          when 0 to 5 =>
            to_all <= to_all and to_std_logic(in_data = x"FF");
            to_me  <= to_me and to_std_logic(in_data = octet(mac_address, index));

          when 6 to 11 =>
            keep := '1';
            demand((to_me or to_all) = '1');

          when 12 =>
            demand(in_data = x"08");

          when 13 =>
            is_arp <= in_data(1);
            demand(in_data = x"06" or in_data = x"00");

          when 14 =>
            demand((is_arp = '1' and in_data = x"00") or (is_arp = '0' and in_data = x"45"));

          when 15 =>
            demand(is_arp = '0' or in_data = x"01");

          when 16 =>
            keep                   := '1';
            remaining(10 downto 8) <= unsigned(in_data(2 downto 0));
            demand((is_arp = '1' and in_data = x"08") or (is_arp = '0' and unsigned(in_data(7 downto 3)) = 0));

          when 17 =>
            keep                  := '1';
            remaining(7 downto 0) <= unsigned(in_data);
            demand(is_arp = '0' or in_data = x"00");

          when 18 =>
            udp_bytes <= remaining - 20;
            demand(is_arp = '0' or in_data = x"06");

          when 19 =>
            demand(is_arp = '0' or in_data = x"04");

          when 20 =>
            demand(unsigned(in_data(5 downto 0)) = 0);

          when 21 =>
            demand((is_arp = '1' and in_data = x"01") or (is_arp = '0' and in_data = x"00"));

          when 23 =>
            is_icmp <= not is_arp and in_data(0) and not in_data(4);
            demand(is_arp = '1' or (in_data = x"01" and to_me = '1') or in_data = x"11");

          when 25 =>
            keep       := '1';
            write_data <= "00000" & (to_all and is_udp) & is_icmp & is_arp;

          when 26 to 29 =>
            keep := not is_arp or to_std_logic(index >= 28);

          when 30 | 31 =>
            keep := '1';

          when 32 | 33 =>
            keep := not is_arp;

          when 34 =>
            keep := not is_arp;
            demand(is_icmp = '0' or in_data = x"08");
            demand(is_arp = '1' or (sum_last = x"FF" and ((sum = x"FF" and carry = '0') or (sum = x"FE" and carry = '1'))));

          when 35 =>
            keep := not is_arp;
            demand(is_icmp = '0' or in_data = x"00");

          when 36 | 37 =>
            keep := not is_arp;
            demand(is_udp = '0' or in_data = octet(port_bits, index - 36));

          when 38 =>
            keep := '1';
            demand(is_udp = '0' or unsigned(in_data) = udp_bytes(10 downto 8));

          when 39 =>
            keep := '1';
            demand(is_udp = '0' or unsigned(in_data) = udp_bytes(7 downto 0));

          when 40 | 41 =>
            keep := '1';

          when 42 =>
            keep := not is_arp and not complete;

          when others =>
            null;

        end case;

        -- The end of the IP datagram. A datagram that ends within the headers is invalid.
        if (counting and not complete and not is_arp) = '1' then
          remaining <= remaining - 1;
          if remaining = 5 then
            complete <= '1';
            demand(index = 41 or index = header);
          end if;
        end if;
        if index = 41 and is_arp = '1' then
          complete <= '1';
        end if;
        if index = 17 then
          counting <= '1';
        end if;

        if summing = '1' then
          total    := resize(sum, 9) + unsigned(in_data) + unsigned'(0 => carry);
          sum      <= sum_last;
          sum_last <= total(7 downto 0);
          carry    <= total(8);
        end if;
        if index = 13 then
          summing <= '1';
        elsif index = 33 then
          summing <= '0';
        end if;

        if (keep and wanted) = '1' then
          write <= not full and not overflow;
          if full = '1' then
            overflow <= '1';
          end if;
        end if;
      end if;

      if (in_valid and in_end) = '1' then
        commit   <= in_data(0) and wanted and complete and not overflow;
        rollback <= not (in_data(0) and wanted and complete and not overflow);
        dropped  <= in_data(0) and wanted and complete and overflow;
      end if;

      if (in_valid and in_end) = '1' or rst = '1' then
        place    <= (others => '0');
        wanted   <= '1';
        to_me    <= '1';
        to_all   <= '1';
        is_arp   <= '0';
        is_icmp  <= '0';
        complete <= '0';
        overflow <= '0';
        counting <= '0';
        summing  <= '0';
        sum      <= (others => '0');
        sum_last <= (others => '0');
        carry    <= '0';
      end if;

      if rst = '1' then
        remaining  <= (others => '0');
        udp_bytes  <= (others => '0');
        write      <= '0';
        write_data <= (others => '0');
        commit     <= '0';
        rollback   <= '1';
        dropped    <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
