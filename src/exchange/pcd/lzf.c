/* Unpacks the compression of .pcd files, LZF. */
#include "exchange/pcd/pcd.h"

#include <string.h>

typedef struct {
    const unsigned char *at, *end;
    char *to;
    size_t made, wanted;
} unpacking;

static bool literal(unpacking *u, size_t count)
{
    if (count > (size_t)(u->end - u->at) || count > u->wanted - u->made)
        return false;
    memcpy(u->to + u->made, u->at, count);
    u->at += count;
    u->made += count;
    return true;
}

/* Bytes from `back` bytes ago; they may run into what they make. */
static bool again(unpacking *u, size_t back, size_t count)
{
    if (back > u->made || count > u->wanted - u->made)
        return false;
    for (size_t i = 0; i < count; i++, u->made++)
        u->to[u->made] = u->to[u->made - back];
    return true;
}

static bool unpack_step(unpacking *u)
{
    const unsigned control = *u->at++;
    if (control < 32)
        return literal(u, control + 1);
    size_t count = control >> 5;
    if (count == 7) {
        if (u->at == u->end)
            return false;
        count += *u->at++;
    }
    if (u->at == u->end)
        return false;
    const size_t back = ((control & 31u) << 8 | *u->at++) + 1;
    return again(u, back, count + 2);
}

batten_status bat_lzf(const char *from, size_t size, char *to, size_t wanted)
{
    const unsigned char *bytes = (const unsigned char *)from;
    unpacking u = {bytes, bytes + size, to, 0, wanted};
    while (u.at < u.end)
        if (!unpack_step(&u))
            return bat_fail(BATTEN_BAD_FORMAT,
                            "the compressed points are damaged at byte %zu of %zu",
                            (size_t)(u.at - bytes), size);
    if (u.made != wanted)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "the compressed points end after %zu bytes instead of %zu", u.made,
                        wanted);
    return BATTEN_OK;
}
