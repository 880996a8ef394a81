/* Rows that forbid cuts the wrong sign of curvature. */
#include "loft/signs.h"
#include "base/arena.h"
#include "loft/bending.h"
#include "fair/sign_pattern.h"

typedef struct {
    bat_loft_place place;
    bat_loft_measure measure;
    double regular; /* |S_u x S_v| */
} sample;

/* Below this part of the largest |S_u x S_v| along a cut its direction is not to be trusted. */
static const double least_regular = 0.02;

/* Samples of the cut at which the surface is regular; corners where two edges are tangent
 * have no direction. */
static int take_samples(const bat_loft_program *p, const bat_loft_cut *cut,
                        const bat_cut_trace *trace, sample *samples, double *curvature)
{
    double largest = 0, normal[3];
    int count = 0;
    for (int k = 0; k < trace->count; k++) {
        bat_loft_place_at(p->patch, trace->u[k], trace->v[k], &samples[k].place);
        samples[k].regular = bat_loft_normal(&samples[k].place, normal);
        largest = bat_max(largest, samples[k].regular);
    }
    for (int k = 0; k < trace->count; k++) {
        const double value = bat_loft_bending(&samples[k].place, cut, &samples[k].measure);
        if (isnan(value) ||
            (!bat_cut_is_edge(cut) && !(samples[k].regular > least_regular * largest)))
            continue;
        curvature[count] = value;
        samples[count++] = samples[k];
    }
    return count;
}

batten_status bat_loft_add_signs(bat_loft_program *program, const bat_loft_cut *cut,
                                 const bat_cut_trace *trace, double price)
{
    bat_arena arena = {0};
    const size_t most = (size_t)trace->count;
    sample *samples = bat_arena_array(&arena, most, sizeof *samples);
    double *curvature = bat_arena_array(&arena, most, sizeof *curvature);
    int *signs = bat_arena_array(&arena, most, sizeof *signs);
    batten_status status = bat_arena_status(&arena);
    const int count =
        status == BATTEN_OK ? take_samples(program, cut, trace, samples, curvature) : 0;
    if (status == BATTEN_OK && count >= 5)
        status = bat_sign_pattern(count, curvature, cut->needed, signs);
    for (int k = 0; k < count && count >= 5 && status == BATTEN_OK; k++) {
        for (int c = 0; c < 3; c++)
            samples[k].measure.vector[c] *= -signs[k];
        status = bat_loft_add_row(program, &samples[k].place, &samples[k].measure,
                                  signs[k] * curvature[k], price);
    }
    bat_arena_free(&arena);
    return status;
}
