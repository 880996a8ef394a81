/* Two curves between whose ends something goes. */
#ifndef BAT_DESIGN_PAIR_H
#define BAT_DESIGN_PAIR_H
#include "design/feature.h"

/* The parameter "ends". */
#define BAT_PAIR_ENDS                                                                        \
    {                                                                                        \
        "ends", BATTEN_VALUE_WORD, false, false, "nearest",                                  \
            "nearest end-start end-end start-start start-end",                               \
            "of two curves: from which end of the first to which end of the second one goes" \
    }

/* The two curves of a parameter, the first run towards the end asked for, the second away from
 * it; give both references back. */
batten_status bat_pair_take(const bat_run *run, const char *parameter, batten_curve *curves[2]);
/* What is left of the first up to u[0], the link, and the second from u[1], as one. */
batten_status bat_pair_join(const batten_curve *const curves[2], const double u[2],
                            const batten_curve *link, double within, batten_curve **out);

#endif
