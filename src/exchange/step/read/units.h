/* Units and accuracy of the contexts of representations. */
#ifndef BAT_STEP_UNITS_H
#define BAT_STEP_UNITS_H
#include "exchange/step/read/shapes.h"

typedef struct {
    double
        unit_metres; /* of the model: that of the first context that was asked for; 0 before */
    double extent;   /* of the points of the file, in its numbers; -1 before it is measured */
    const bat_step_instance *last; /* the context asked for last, and its scale */
    bat_step_scale scale;
    bool noted_none, noted_other, noted_angle, noted_accuracy, noted_factor;
} bat_step_units;

void bat_step_units_begin(bat_step_units *units);
/* The units of a context; NULL or one without units: millimetre and radian, with a note. */
void bat_step_units_of(const bat_step_file *file, bat_step_units *units,
                       const bat_step_instance *context, bat_step_scale *scale);

#endif
