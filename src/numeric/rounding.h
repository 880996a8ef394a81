/* What counts as nothing beside a size of the same unit. Each is a share of that size, explained
 * here once; a test against another number says at its place where that number comes from. */
#ifndef BAT_ROUNDING_H
#define BAT_ROUNDING_H

/* What exact constructions (a knot inserted, a part taken, a degree raised) leave: some hundred
 * operations, each rounding by half of 2.2e-16 of the largest number. */
#define BAT_EXACT 1e-13

/* What chains of constructions and solved systems leave: ten times that, so that nothing which
 * is only rounding is taken for a difference. */
#define BAT_ROUNDING 1e-12

/* Points, parameters and numbers that were meant to be the same: nine digits are more than
 * files and drawings give, and a thousand times what constructions lose. */
#define BAT_MEANT_SAME 1e-9

/* The least sine between two directions that have a plane. A cross product of unit vectors is
 * wrong by about 1e-16, so its own direction has seven digits left there, and fewer below. */
#define BAT_LEAST_SINE 1e-9

#endif
