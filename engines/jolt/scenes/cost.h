#pragma once

// CPU time of a step, in microseconds, of 200 boxes that fall on a pile and settle.
double PileMicroseconds();

// The same of 196 boxes that all slide and spin apart from each other.
double SlidingMicroseconds();
