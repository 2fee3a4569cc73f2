/* Prints the text frames that the client makes of a gateway's bytes, in both forms.
 *
 * Each line of the input is a case: the digits of an ID, of a CRC and of an address, the number of the node or -1, the
 * bytes in each read, and the bytes in hexadecimal digits. For each case it prints the complete frames with their line
 * ends, as text in hexadecimal digits. */
#include "unity_link.c"

static text arriving;
static size_t most_at_a_time;

static ptrdiff_t receive_some(void *context, void *bytes, size_t size)
{
    (void)context;
    size_t count = 0;
    for (uint64_t byte; count < size && count < most_at_a_time && take_number(&arriving, 2, &byte); count++)
        ((char *)bytes)[count] = (char)byte;
    return (ptrdiff_t)count;
}

int main(void)
{
    static ul_link link;
    static char digits[1 << 20];
    unsigned id_digits, crc_digits, address_digits;
    int node;
    while (scanf("%u %u %u %d %zu %1048575s", &id_digits, &crc_digits, &address_digits, &node, &most_at_a_time, digits) == 6) {
        memset(&link, 0, sizeof link);
        link.info.id_digits = id_digits;
        link.crc_digits = crc_digits;
        link.address_digits = address_digits;
        link.node = node;
        link.compact = true;
        link.transport.receive = receive_some;
        arriving = (text){digits, strlen(digits)};
        while (fill(&link))
            for (text line; next_line(&link, &line);) {
                for (size_t index = 0; index < line.size; index++) printf("%02X", (unsigned char)line.at[index]);
                printf("0A");
            }
        printf("\n");
        fflush(stdout);
    }
    return 0;
}
