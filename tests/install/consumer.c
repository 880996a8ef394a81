/* A program of somebody else, in C. */
#include <batten/batten.h>
#include <batten/design.h>
#include <batten/picture.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    batten_curve *arc = NULL;
    double point[2];
    if (batten_curve_arc(2.0, 1.0, &arc) != BATTEN_OK ||
        batten_curve_evaluate(arc, 0.5, 0, point) != BATTEN_OK) {
        printf("%s\n", batten_message());
        return 1;
    }
    batten_curve_unref(arc);
    batten_picture_format format;
    return fabs(hypot(point[0], point[1]) - 2) < 1e-14 && batten_feature_count() > 0 &&
                   batten_picture_format_from_name("a.svg", &format)
               ? 0
               : 1;
}
