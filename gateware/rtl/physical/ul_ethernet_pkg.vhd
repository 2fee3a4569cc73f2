-- SPDX-License-Identifier: BSD-3-Clause
--
-- What the parts of `ul_ethernet` tell each other: banks and slots of the memory of hosts, and what is to be sent.

library ieee;
  use ieee.std_logic_1164.all;

package ul_ethernet_pkg is

  subtype bank_t is std_logic_vector(1 downto 0);

  -- A bank, and one of its 32 slots.
  subtype peer_address_t is std_logic_vector(6 downto 0);

  -- That of this gateway: address of the MAC (slots 0 to 5), of IP (6 to 9), build identifier (10 to 13), digits of the
  -- session on offer (16 to 23), mark of a question who is there (30, 31).
  constant own_bank : bank_t := "11";

  constant find_mark : std_logic_vector(15 downto 0) := x"553F";

  -- Bytes of a question who is there, at least, and of the answer.
  constant find_bytes : positive := 32;

  -- What is sent beside the answers of the core: the answer to a question for an address, to a ping, to a question who
  -- is there, and X0A under the session that is refused.

  type job_t is (job_none, job_arp, job_echo, job_find, job_refuse);

  -- Most bytes of UDP in a datagram (docs/protocol.md, "Datagrams").
  constant largest_datagram : positive := 1400;

  -- An octet of an address, the first one as number 0; there is none beyond the last.
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
