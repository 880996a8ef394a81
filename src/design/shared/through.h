/*
 * What every method "points to curve" shares as a feature: it takes rows of points out of the
 * input, hands each row to the method, and puts what the method made into the model.
 *
 * A method says in what form it wants its points: in space, [count][3]; in a plane, [count][2],
 * that of two axes in which the row lies (a row that lies in none is refused); as a function,
 * [count] values over increasing abscissae. One that can do two of them (BAT_IN_SPACE |
 * BAT_AS_FUNCTION, say) has the parameter BAT_AS, with which the user chooses.
 */
#ifndef BAT_DESIGN_THROUGH_H
#define BAT_DESIGN_THROUGH_H
#include "design/shared/rows.h"
#include <batten/chain.h>
#include <batten/interpolate.h>

#define BAT_IN_SPACE 1u
#define BAT_IN_PLANE 2u
#define BAT_AS_FUNCTION 4u

/* Parameters that are the same for all such features. */
#define BAT_EACH                                                                \
    {                                                                           \
        "each", BATTEN_VALUE_WORD, false, false, "station", "station line row", \
            "of a table: one curve through each of these"                       \
    }
#define BAT_AS                                                                            \
    {                                                                                     \
        "as", BATTEN_VALUE_WORD, false, false, "curve", "curve function",                 \
            "a curve, or a function: the points rise along the first axis in which they " \
            "differ"                                                                      \
    }
#define BAT_PARAMETRIZATION                                     \
    {                                                           \
        "parameters", BATTEN_VALUE_WORD, false, false, "chord", \
            "centripetal chord uniform foley foley-chord",      \
            "how points get parameters; of a "                  \
            "function they are the abscissae"                   \
    }
#define BAT_CLOSED                                                       \
    {                                                                    \
        "closed", BATTEN_VALUE_YES_NO, false, false, "no", NULL,         \
            "the curve closes smoothly; the first point is not repeated" \
    }

/* One row, in the form the method wants. */
typedef struct {
    const char *name;
    int dimension; /* 3, 2, or 1: a function */
    int count;
    const double *points;    /* [count][dimension] */
    const double *abscissae; /* [count], increasing, of a function; else NULL */
    int axis;                /* the coordinate that the plane leaves out; -1: in space */
} bat_data;

/* What a method makes of a row: a curve or a chain, of the dimension of the data; of a function
 * also its graph, a curve of dimension 2. */
typedef struct {
    batten_curve *curve;
    batten_chain *chain;
    double *parameters; /* [count], zeros: fill in those of the points; or set has_parameters
                           to false when the points have none */
    bool is_elsewhere;  /* the curve was moved away from the points: they are no data of it */
    bool has_parameters;
    bool from_polygon; /* the points are the vertices of a polygon that shapes the curve */
    bool has_error;    /* of an approximation */
    double error_max, error_rms;
} bat_made;

typedef struct {
    int least;     /* points that are needed; rows with fewer are left out with a note */
    unsigned ways; /* BAT_IN_SPACE ... */
    batten_status (*make)(bat_run *run, const bat_data *data, bat_made *made);
} bat_method;

/* The abscissae of a function are its parameters. */
static inline batten_parametrization bat_parametrization_of(const bat_run *run,
                                                            const bat_data *data)
{
    return data->dimension == 1 ? BATTEN_GIVEN
                                : (batten_parametrization)bat_word(run, "parameters");
}

/* A function has no place where it closes. */
static inline batten_status bat_check_closed(const bat_run *run, const bat_data *data)
{
    return data->dimension == 1 && bat_yes(run, "closed")
               ? bat_fail(BATTEN_BAD_ARGUMENT, "a function cannot be closed")
               : BATTEN_OK;
}

/* The numbers of a list, one for each of `count` things ("spans"), or one for all; release
 * them. */
batten_status bat_numbers_each(const bat_run *run, const char *parameter, int count,
                               const char *things, double **out);

/* The list of counted points that a parameter has; release them. */
batten_status bat_indices(const bat_run *run, const char *parameter, int *count, int **out);

/* Run the method on each row of the principal input. The parameters must include BAT_EACH, and
 * BAT_AS when there are several ways. A chain is also converted to a curve, within a thousandth
 * of the design's tolerance; messages get the name of the row. */
batten_status bat_through(bat_run *run, const bat_method *method);
/* How far the curve of an object may be from its chain: that thousandth; 0 without a chain. */
double bat_chain_error(const bat_run *run, const batten_object *object);

#endif
