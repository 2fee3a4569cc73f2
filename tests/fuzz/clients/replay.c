/* Passes files to a target, as libFuzzer does. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int main(int count, char **paths)
{
    for (int index = 1; index < count; index++) {
        FILE *file = fopen(paths[index], "rb");
        if (file == NULL) return 2;
        /* Each piece is copied to memory of its exact size, so that a sanitizer reports a read beyond its end. */
        static uint8_t read[1 << 16];
        size_t size = fread(read, 1, sizeof read, file);
        fclose(file);
        for (size_t piece = 0; piece <= 10; piece++) {
            size_t taken = size * piece / 10;
            uint8_t *data = malloc(taken ? taken : 1);
            if (data == NULL) return 2;
            for (size_t at = 0; at < taken; at++) data[at] = read[at];
            LLVMFuzzerTestOneInput(data, taken);
            free(data);
        }
    }
    return 0;
}
