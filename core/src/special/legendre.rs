//! Gauss–Legendre rules of 4, 6, 8, 10 and 16 points on [−1, 1].

use crate::real::Real;

/// Points of the rules for double and for single precision: half the points are exact to half the digits.
pub(crate) const POINTS: usize = 16;
pub(crate) const FEW_POINTS: usize = 8;

/// Positive nodes and their weights: roots of P₁₆ and 2/((1−x²) P₁₆'²) by mpmath 1.3 with 60 digits,
/// `taylor(lambda x: legendre(16, x), 0, 16)` and `polyroots`.
pub(crate) const HALF: [[f64; 2]; POINTS / 2] = [
    [0.095_012_509_837_637_44, 0.189_450_610_455_068_5],
    [0.281_603_550_779_258_9, 0.182_603_415_044_923_58],
    [0.458_016_777_657_227_37, 0.169_156_519_395_002_54],
    [0.617_876_244_402_643_8, 0.149_595_988_816_576_74],
    [0.755_404_408_355_003, 0.124_628_971_255_533_88],
    [0.865_631_202_387_831_8, 0.095_158_511_682_492_79],
    [0.944_575_023_073_232_6, 0.062_253_523_938_647_894],
    [0.989_400_934_991_649_9, 0.027_152_459_411_754_096],
];

/// The same for P₈.
pub(crate) const FEW_HALF: [[f64; 2]; FEW_POINTS / 2] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_27],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
];

/// The same for P₄, P₆ and P₁₀.
pub(crate) const OF_4: [[f64; 2]; 2] = [
    [0.339_981_043_584_856_26, 0.652_145_154_862_546_1],
    [0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
];
pub(crate) const OF_6: [[f64; 2]; 3] = [
    [0.238_619_186_083_196_9, 0.467_913_934_572_691_04],
    [0.661_209_386_466_264_5, 0.360_761_573_048_138_6],
    [0.932_469_514_203_152, 0.171_324_492_379_170_36],
];
pub(crate) const OF_10: [[f64; 2]; 5] = [
    [0.148_874_338_981_631_22, 0.295_524_224_714_752_87],
    [0.433_395_394_129_247_2, 0.269_266_719_309_996_35],
    [0.679_409_568_299_024_4, 0.219_086_362_515_982_04],
    [0.865_063_366_688_984_5, 0.149_451_349_150_580_6],
    [0.973_906_528_517_171_7, 0.066_671_344_308_688_14],
];

/// Nodes and weights of 16 points on [−1, 1], of 8 in single precision.
#[inline(always)]
pub(crate) fn each_node<R: Real>(mut visit: impl FnMut(R, R)) {
    let mut both = |[node, weight]: [f64; 2]| {
        let (node, weight) = (R::from_f64(node), R::from_f64(weight));
        visit(-node, weight);
        visit(node, weight);
    };
    if R::IS_SINGLE {
        FEW_HALF.into_iter().for_each(&mut both);
    } else {
        HALF.into_iter().for_each(&mut both);
    }
}
