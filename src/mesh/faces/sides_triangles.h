/* What sides.c and sides_insert.c both need of the triangles. */
#ifndef BAT_SIDES_TRIANGLES_H
#define BAT_SIDES_TRIANGLES_H
#include "mesh/faces/sides.h"
#include "numeric/plane_signs.h"
#include <limits.h>

static inline int after(int k)
{
    return k == 2 ? 0 : k + 1;
}

static inline int before(int k)
{
    return k == 0 ? 2 : k - 1;
}

static inline const double *at(const bat_sides *s, int vertex)
{
    return s->at[vertex];
}

static inline void set_bit(unsigned char *bits, int k, bool on)
{
    *bits = (unsigned char)((*bits & ~(1u << k)) | (unsigned)on << k);
}

static inline bool bit(unsigned char bits, int k)
{
    return bits >> k & 1;
}

/* Room for so many; the list never has less than before. */
batten_status bat_sides_grow_vertices(bat_sides *s, int room);
batten_status bat_sides_grow_triangles(bat_sides *s, int room);
batten_status bat_sides_grow_list(bat_sides *s, int room);

#endif
