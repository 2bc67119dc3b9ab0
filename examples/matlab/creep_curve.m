% The creep curve of a wheel on a rail by both theories, in MATLAB and in Octave.
bodies = struct('rolling_radius', [0.46 Inf], 'transverse_radius', [Inf 0.3], ...
                'young_modulus', [210e9 210e9], 'poisson_ratio', [0.28 0.28]);
hertz = microslip('hertz', bodies, 80e3);
contact = struct('a', hertz.a, 'b', hertz.b, 'shear_modulus', hertz.shear_modulus, ...
                 'poisson_ratio', hertz.poisson_ratio, 'normal_force', 80e3, 'friction', 0.3);
contact.creepage_longitudinal = [0 0.0005 0.001 0.002 0.004 0.008];
simplified = microslip('fastsim2', contact);
exact = microslip('exact', contact);
fprintf('%8.4f %10.1f %10.1f N\n', [contact.creepage_longitudinal; simplified.fx; exact.fx]);
