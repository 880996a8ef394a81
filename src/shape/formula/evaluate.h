/* A surface that is a formula as it is stored, and its values at parameters. */
#ifndef BAT_FORMULA_EVALUATE_H
#define BAT_FORMULA_EVALUATE_H
#include "shape/formula/formula.h"

enum {
    BAT_FORMULA_HIGHEST_ORDER = 3,
    BAT_FORMULA_LIKE_DEGREE = 5 /* roundoff of derivatives is taken to be as of this degree */
};

/* The formula, which a surface shares with its images under maps. */
typedef struct {
    bat_references references;
    bat_surface_kind kind; /* with the formula's name */
    bat_formula formula;
    void *data;
} bat_formula_shared;

typedef struct {
    batten_surface base;
    bat_formula_shared *shared;
    bool mapped;
    batten_affine map;
    int count[2]; /* of the breaks */
    int smoothness[2];
    double *spans[2];  /* one block */
    bool turned;       /* u runs against that of the formula */
    double *formula_u; /* [count[0]], in the same block: the formula's own breaks */
    double size;
    batten_box box;
} bat_formula_surface;

static inline const bat_formula_surface *bat_formula_of(const batten_surface *surface)
{
    return (const bat_formula_surface *)(const void *)surface;
}

static inline batten_interval bat_formula_domain(const batten_surface *surface,
                                                 batten_direction direction)
{
    const bat_formula_surface *made = bat_formula_of(surface);
    const double *spans = made->spans[direction];
    return (batten_interval){spans[0], spans[made->count[direction] - 1]};
}

/* What the table of a formula's kind names (bat_surface_kind). */
batten_status bat_formula_evaluate(const batten_surface *surface, const bat_surface_place *at,
                                   int order, double *out);
batten_status bat_formula_evaluate_many(const batten_surface *surface, batten_batch uv,
                                        int order, const batten_job *job, double *out);
batten_status bat_formula_evaluate_grid(const batten_surface *surface, batten_uv_grid places,
                                        int order, const batten_job *job, double *out);
batten_status bat_formula_normal_grid(const batten_surface *surface, batten_uv_grid places,
                                      const batten_job *job, double *points, double *normals);
void bat_formula_local(const batten_surface *surface, const bat_surface_place *at,
                       bat_surface_local *out);
/* How smooth a surface is known to be across its inner spans; 0 for one that is not a formula. */
int bat_formula_smoothness(const batten_surface *surface, batten_direction direction);

#endif
