/* Curves of which a function returns as many as there are: giving them back. */
#include "base/base.h"
#include <batten/offset.h>

void batten_curves_release(batten_curves *curves)
{
    for (int i = 0; i < curves->count; i++)
        batten_curve_unref(curves->at[i]);
    bat_release(curves->at);
    *curves = (batten_curves){0, NULL};
}
