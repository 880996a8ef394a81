/* A sheet with polygons as loops. */
#ifndef TESTS_BODY_CHECK_SHEET_H
#define TESTS_BODY_CHECK_SHEET_H
#include <batten/body.h>

/* A square of side 4, of a plane in its own parameters, u = x and v = y, with more loops of
 * polygons, of so many corners each, `count` in all. */
batten_body *sheet_with_loops(int count, const double (*corners)[2], const int *sizes,
                              int loops);

#endif
