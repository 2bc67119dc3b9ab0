% The creep curve of a wheel on a rail by both theories, in MATLAB and in Octave.
bodies = struct('rolling_radius', [0.46 Inf], 'transverse_radius', [Inf 0.3], ...
                'young_modulus', [210e9 210e9], 'poisson_ratio', [0.28 0.28]);
hertz = microslip('hertz', bodies, 80e3);
contact = struct('a', hertz.a, 'b', hertz.b, 'shear_modulus', hertz.shear_modulus, ...
                 'poisson_ratio', hertz.poisson_ratio, 'normal_force', 80e3, 'friction', 0.3);
contact.creepage_longitudinal = [0 0.0005 0.001 0.002 0.004 0.008];
simplified = microslip('fastsim2', contact);

problem = microslip('create', 'bodies');
for k = 1:2
  body = sprintf('body%d.', k);
  microslip('set', problem, [body 'rolling_radius'], bodies.rolling_radius(k), ...
            [body 'transverse_radius'], bodies.transverse_radius(k), ...
            [body 'young_modulus'], bodies.young_modulus(k), [body 'poisson_ratio'], bodies.poisson_ratio(k));
end
microslip('set', problem, 'load.normal_force', '80 kN', 'friction.coefficient', 0.3, 'motion.rolling_speed', 1, ...
          'solution.theory', 'exact', 'solution.grid', [24 24]);
exact = zeros(size(simplified.fx));
for k = 1:numel(exact)
  microslip('set', problem, 'motion.creepage_longitudinal', contact.creepage_longitudinal(k));
  microslip('solve', problem);
  exact(k) = microslip('number', problem, 'fx');
end
microslip('destroy', problem);
fprintf('%8.4f %10.1f %10.1f N\n', [contact.creepage_longitudinal; simplified.fx; exact]);
