# A sphere that spins about its normal is pushed over a plane: what friction leaves of its motion.
#
#   lmp -in in.spin -var plugin PATH/tribosplugin.so
#   lmp -in in.spin -var plugin PATH/tribosplugin.so -var coupling separate
#
# Units: diameter, mass and gravity are 1.

variable plugin   index tribosplugin.so
variable coupling index exact       # exact, ellipsoid, separate or none
variable spin     index 200

plugin load ${plugin}
units lj
atom_style sphere
comm_modify vel yes
boundary f f f
region box block -5 60 -5 5 0 5
create_box 1 box
create_atoms 1 single 0 0 0.4999
set group all diameter 1.0
set group all density 1.909859317102744
set group all omega 0 0 ${spin}
velocity all set 1 0 0

pair_style gran/tribos
pair_coeff * * hooke 1e4 damping 0.5 sliding 0.3 coupling ${coupling}
fix move all nve/sphere
fix weight all gravity 1.0 vector 0 0 -1
fix plane all wall/gran/tribos hooke 1e4 damping 0.5 sliding 0.3 coupling ${coupling} zlo 0

compute x all property/atom xu
compute vx all property/atom vx
compute w all property/atom omegaz
compute way all reduce sum c_x
compute speed all reduce sum c_vx
compute spin all reduce sum c_w
thermo 1000
thermo_style custom time c_way c_speed c_spin
timestep 0.0005
run 6000
