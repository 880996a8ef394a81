/* The curve of an edge in the parameters of a surface: with its domain, so that both are at the
 * same place at the same t. */
#ifndef BAT_PARAMETERS_H
#define BAT_PARAMETERS_H
#include "body/trace/chart.h"

/* The largest |S(B(t)) - C(t)| at samples: four in each span of either curve, 16 at least. The
 * search ends early once it is above `enough`. B is a curve of the chart's plane. */
batten_status bat_parameters_miss(const bat_chart *chart, const batten_curve *curve,
                                  const batten_curve *parameters, double enough, double *miss);
/* Are all control points in the domain, in the directions that do not close? */
bool bat_parameters_inside(const bat_chart *chart, const batten_curve *parameters);
/* A copy with its control points between low and high, and with given end points where these
 * are not NULL. */
batten_status bat_parameters_adjust(const batten_curve *parameters, const double low[2],
                                    const double high[2], const double *start,
                                    const double *end, batten_curve **out);

/* Is the surface a plane with straight, even parameters? */
bool bat_parameters_plane(const bat_chart *chart);
/* Of an edge in a plane: exact, with the knots and weights of the edge. NOT_FOUND when the
 * surface is no plane with straight, even parameters, or the edge is not in it. Control points
 * may lie beyond the domain. */
batten_status bat_parameters_in_plane(const bat_chart *chart, const batten_curve *curve,
                                      batten_curve **out, double *miss);
/* The straight line from foot to foot when it is good; else NOT_FOUND. */
batten_status bat_parameters_straight(bat_chart *chart, const batten_curve *curve,
                                      const double *guess, batten_curve **out, double *miss);
/* By feet and their velocities along the curve, halved where it misses. */
batten_status bat_parameters_follow(bat_chart *chart, const batten_curve *curve,
                                    const double *guess, batten_curve **out, double *miss);

/*
 * The given curve when it is good, mapped to the domain of the edge; else a new one, by the
 * first of the ways above. TOLERANCE_NOT_MET when the edge is not on the surface.
 * @param given may be NULL, or of any domain
 * @param guess where the first point is likely to be; may be NULL
 */
batten_status bat_parameters_of_edge(bat_chart *chart, const batten_curve *curve,
                                     const batten_curve *given, const double *guess,
                                     batten_curve **out, bool *kept, double *miss);

#endif
