#include "design/expect.h"

/* The ellipse nearest to points, which lie on one of half axes 3 and 2 about (1, 2), turned by 30 degrees. */

static const char data[] =
    "  turned: {points: [[3.34761833063672, 3.81420524160462], [2.21934468430976, 4.2781662680794], [0.731424157797225, 4.07017997612833], [-0.677279667331056, 3.25159212137254], [-1.5912682513003, 2.06384597404479], [-1.74095978760445, 0.857268395643389], [-1.08220261452333, -0.0122594037376182]]}\n"
    "  back: {points: [[-1.08220261452333, -0.0122594037376182], [-1.74095978760445, 0.857268395643389], [-1.5912682513003, 2.06384597404479], [-0.677279667331056, 3.25159212137254], [0.731424157797225, 4.07017997612833], [2.21934468430976, 4.2781662680794], [3.34761833063672, 3.81420524160462]]}\n"
    "  five: {points: [[3.34761833063672, 3.81420524160462], [2.21934468430976, 4.2781662680794], [0.731424157797225, 4.07017997612833], [-0.677279667331056, 3.25159212137254], [-1.5912682513003, 2.06384597404479]]}\n"
    "  four: {points: [[3.34761833063672, 3.81420524160462], [2.21934468430976, 4.2781662680794], [0.731424157797225, 4.07017997612833], [-0.677279667331056, 3.25159212137254]]}\n"
    "  flat: {points: [[0, 0], [1, 1], [2, 2], [3, 3], [4, 4]]}\n"
    "  bow: {points: [[-2, 4], [-1, 1], [0, 0], [1, 1], [2, 4]]}\n"
    "  skew: {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1], [0, 2, 3]]}\n";

static const expect_row rows[] = {
    {"{fit-ellipse: turned}", BATTEN_OK,
     "closed 1;domain 0 1;within 1e-9;length 15.865439589290589;notes 'turned': an ellipse with the "
     "semi-axes 3 and 2;error 1e-9;on 0 0 1 0"},
    {"{fit-ellipse: five}", BATTEN_OK,
     "closed 1;within 1e-8;length 15.865439589290589;notes semi-axes 3 and 2"},
    {"{fit-ellipse: turned, whole: no}", BATTEN_OK,
     "closed 0;domain 0 1;within 1e-9;at 0 3.34761833064 3.8142052416 0;at 1 -1.08220261452 -0.0122594037376 0"},
    {"{fit-ellipse: back, whole: no}", BATTEN_OK,
     "closed 0;domain 0 1;within 1e-9;at 0 -1.08220261452 -0.0122594037376 0;at 1 3.34761833064 3.8142052416 0"},
    {"{fit-ellipse: four}", BATTEN_TOO_FEW_POINTS, "no row has 5 points"},
    {"{fit-ellipse: flat}", BATTEN_SINGULAR_SYSTEM, "lie on a line"},
    {"{fit-ellipse: bow}", BATTEN_SINGULAR_SYSTEM, "the 5 points determine no ellipse"},
    {"{fit-ellipse: skew}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
};

TEST(a_fitted_ellipse_is_that_of_its_points_whole_or_beside_them_and_runs_as_they_do)
{
    EXPECT(data, rows);
}
