-- SPDX-License-Identifier: BSD-3-Clause
--
-- Types and constants shared by the parts of `ul_ethernet`: banks and slots of the memory of hosts, and datagrams to
-- send.

library ieee;
  use ieee.std_logic_1164.all;

package ul_ethernet_pkg is

  subtype bank_t is std_logic_vector(1 downto 0);

  -- Address of a slot: bank (2 bits) and slot (5 bits, 0 to 31).
  subtype peer_address_t is std_logic_vector(6 downto 0);

  -- The bank of this gateway: MAC address (slots 0 to 5), IP address (6 to 9), build identifier (10 to 13), digits of
  -- the session on offer (16 to 23), mark of a discovery request (30, 31).
  constant own_bank : bank_t := "11";

  constant find_mark : std_logic_vector(15 downto 0) := x"553F";

  -- Minimum length in bytes of a discovery request, and length of its answer.
  constant find_bytes : positive := 32;

  -- Datagrams sent besides the answers of the core: the answers to an ARP request, to a ping and to a discovery
  -- request, and X0A under the session that is refused.

  type job_t is (job_none, job_arp, job_echo, job_find, job_refuse);

  -- Maximum UDP payload of a datagram in bytes (docs/protocol.md, "Datagrams").
  constant largest_datagram : positive := 1400;

  -- Octet `number` of an address, 0 for the first; x"00" after the last.
  function octet (address : std_logic_vector; number : natural) return std_logic_vector;

end package ul_ethernet_pkg;

package body ul_ethernet_pkg is

  function octet (address : std_logic_vector; number : natural) return std_logic_vector is

    constant bits   : std_logic_vector(address'length - 1 downto 0) := address;
    variable result : std_logic_vector(7 downto 0);

  begin

    result := (others => '0');

    for place in 0 to address'length / 8 - 1 loop

      if number = place then
        result := bits(address'length - 8 * place - 1 downto address'length - 8 * place - 8);
      end if;

    end loop;

    return result;

  end function octet;

end package body ul_ethernet_pkg;
