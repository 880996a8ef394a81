/* Give each file of the folders named to the target, once: so that corpora are tests under any
 * compiler. */
#define _XOPEN_SOURCE 700
#include "promise.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>

static void replay_file(const char *path)
{
    char *data = NULL;
    size_t size = 0;
    if (batten_load_file(path, (size_t)1 << 30, &data, &size) != BATTEN_OK) {
        fprintf(stderr, "%s\n", batten_message());
        exit(1);
    }
    /* A copy without the byte that follows: reading past the end shows under the sanitizer. */
    uint8_t *copy = malloc(size ? size : 1);
    if (!copy)
        exit(1);
    for (size_t i = 0; i < size; i++)
        copy[i] = (uint8_t)data[i];
    batten_release(data);
    LLVMFuzzerTestOneInput(copy, size);
    free(copy);
}

static int replay_folder(const char *folder)
{
    int count = 0;
    DIR *directory = opendir(folder);
    if (!directory) {
        perror(folder);
        exit(1);
    }
    for (const struct dirent *entry; (entry = readdir(directory));) {
        char path[1024];
        if (entry->d_name[0] == '.')
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        replay_file(path);
        count++;
    }
    closedir(directory);
    return count;
}

int main(int count, char **folders)
{
    int files = 0;
    for (int i = 1; i < count; i++)
        files += replay_folder(folders[i]);
    printf("%d files replayed\n", files);
    return files > 0 ? 0 : 1;
}
