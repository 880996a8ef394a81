/* What reports say of bodies and meshes. */
#ifndef BAT_DESIGN_SOLIDS_H
#define BAT_DESIGN_SOLIDS_H
#include "design/feature.h"
#include <batten/text.h>

/* A report's parameter 'within', when it is given, must be above 0. */
batten_status bat_check_within(const bat_run *run);

/* Areas, volumes, centroids and boxes of a body or mesh, as text or JSON; `partly` of the run
 * is set when faces cannot be measured. */
batten_status bat_measure_solid(bat_run *run, const batten_object *object, bool json,
                                batten_text *out);

/* How many points there are in a row of points or a table of offsets, and their box. */
void bat_measure_points(const batten_object *object, bool json, batten_text *out);

/* What is wrong with a body or a mesh. */
typedef struct {
    double tolerance; /* of the body: what counts as a gap */
    batten_body_faults body;
    batten_mesh_facts mesh;
} bat_solid_faults;

/* @param tolerance  model units; 0: that of the file of the body */
batten_status bat_check_solid(const bat_run *run, const batten_object *object, double tolerance,
                              bat_solid_faults *out);
/* Is it free of what keeps others from working with it? */
bool bat_solid_holds(const batten_object *object, const bat_solid_faults *faults);
/* One line; and ", "key": value" pairs. */
void bat_solid_text(const batten_object *object, const bat_solid_faults *faults,
                    batten_text *out);
void bat_solid_json(const batten_object *object, const bat_solid_faults *faults,
                    batten_text *out);

#endif
