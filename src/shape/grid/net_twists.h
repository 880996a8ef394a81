/* Twists of nets: what the methods share. */
#ifndef BAT_NET_TWISTS_H
#define BAT_NET_TWISTS_H
#include "base/base.h"
#include <batten/coons.h>

/* A net with its tangents; arrays [count_u][count_v][dimension]. */
typedef struct {
    int dimension, count[2];
    const double *at[2]; /* the parameters */
    const double *points, *su, *sv;
} bat_net;

static inline size_t bat_net_index(const bat_net *net, int i, int j)
{
    return ((size_t)i * (size_t)net->count[1] + (size_t)j) * (size_t)net->dimension;
}

/* Two lines or more, at finite rising parameters; `name` of the direction for messages. */
batten_status bat_net_check_axis(char name, int count, const double *t);

/* Those of least energy (net_twists_energy.c). */
batten_status bat_net_energy_twists(const bat_net *net, double *twists);

#endif
