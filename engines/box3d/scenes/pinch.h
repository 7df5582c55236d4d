#pragma once

// A capsule that two pads pinch under gravity: prints its creep as a line of CSV.
void print_capsule_creep( void );
