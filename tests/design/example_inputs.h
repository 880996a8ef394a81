/* The files that examples of the manual read: a hull, a boat and a solid. */
#ifndef TESTS_DESIGN_EXAMPLE_INPUTS_H
#define TESTS_DESIGN_EXAMPLE_INPUTS_H

/* offsets.csv, sharpie.csv and block.step, in the folder that test_scratch names. */
void write_example_inputs(void);

#endif
