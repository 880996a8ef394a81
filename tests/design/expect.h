/* Tables of features and what must be true of them: each row is one feature of a design, and facts of its
 * result or words of its refusal. */
#ifndef TESTS_DESIGN_EXPECT_H
#define TESTS_DESIGN_EXPECT_H
#include "support/test.h"

#include <batten/design.h>

/*
 * Facts are separated by ';', each a word and its numbers:
 *
 *     objects n                how many objects there are
 *     object i                 what follows is about this one; 0 at first
 *     named text, layer text, kind text
 *     within t                 what follows holds to this tolerance; 1e-9 at first
 *     degree p [q], count n [m], rational 0|1, closed 0|1, domain a b
 *     at s x y z               the curve at the fraction s of its domain; by numbers of a fraction and a point,
 *     at s t x y z             or the surface
 *     heads s x y z            the unit tangent of the curve at a fraction
 *     bends s k                its curvature there;  spans n: of a chain, or 0 when it is none
 *     normal s t x y z         the unit normal of the surface
 *     joins i s j t            end to end: object i at the fraction s is object j at the fraction t
 *     length l, area a, volume v
 *     finer n                  a mesh has at least so many triangles
 *     box x y z x y z          of all objects
 *     control i x y z          a control point;  data i x y z: a point that belongs to the object
 *     passes                   the data lie on the curve, at their parameters
 *     distance r x y z         all of the object is so far from this point
 *     along r x y z u v w      all of the object is so far from the line through a point in this direction
 *     on a b c d               all of the object satisfies a x + b y + c z = d
 *     error e                  the error that is reported is at most e, and is reported
 *     reached                  that error and its root mean square are those of the data at their parameters
 *     moves n d                fairing moved n points, none farther than d
 *     exact                    no error is reported
 *     notes words              the notes say so;  lacks words: none does;  silent: there are no notes
 *     colour r g b             of the object, 0 to 1;  plain: it has none
 */
typedef struct {
    const char *feature; /* what follows "a: " */
    batten_status status;
    const char *facts; /* or words of the message */
} expect_row;

/* Evaluate each feature as `a`, after these lines of a design. */
void expect_rows(const char *before, const expect_row *rows, int count);
/* The same for each of some features, whose name is written @. */
void expect_each(const char *before, const char *const *names, int name_count,
                 const expect_row *rows, int row_count);
/* Make each output, as "m.txt: {measure: ring}", which must have all words between '|'; none behind '!'. */
void expect_outputs(const char *before, const expect_row *rows, int count);
#define EXPECT(before, rows) expect_rows(before, rows, COUNT(rows))
#define EXPECT_OUTPUTS(before, rows) expect_outputs(before, rows, COUNT(rows))

#endif
