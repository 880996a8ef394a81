/* What holds for every traced body. */
#ifndef TESTS_BODY_TRACED_H
#define TESTS_BODY_TRACED_H
#include <batten/body.h>

/* All parameter curves are within the tolerance of their edges at 50 places, inside the domain
 * of their surface; uses that follow one another meet in (u, v) to the bit; the first loop of
 * each face is counter-clockwise in (u, v), the others clockwise, turned when it is reversed.
 */
void check_traced(const batten_body *body, double tolerance);

#endif
