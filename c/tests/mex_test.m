% Of the MEX file, in Octave: octave-cli mex_test.m FOLDER_OF_THE_MEX_FILE ROOT_OF_THE_SOURCES
arguments = argv();
addpath(arguments{1});
root = arguments{2};

% The example runs, and its curve has the shape of one.
run(fullfile(root, 'examples', 'matlab', 'creep_curve.m'));
limit = contact.friction * contact.normal_force;
assert(all(diff(exact) < 0) && all(abs(exact) <= limit * (1 + 1e-12)));
assert(exact(1), 0, 1e-6 * limit);
assert(simplified.fx, exact, 0.05 * limit);
assert(simplified.status, zeros(size(exact)));

% Hertz's closed form for a sphere on a flat: a^3 = 3 Fn R / (4 E*).
sphere = struct('rolling_radius', [0.1 Inf], 'transverse_radius', [0.1 Inf], ...
                'young_modulus', [210e9 210e9], 'poisson_ratio', [0.3 0.3]);
round = microslip('hertz', sphere, 1000);
assert(round.a, (3 * 1000 * 0.1 / (4 * 210e9 / (2 * (1 - 0.09))))^(1 / 3), 1e-12);

% Arrays keep their shape, and a contact does not depend on its neighbours.
many = contact;
many.creepage_longitudinal = [0.0005 0.001; 0.002 0.004];
found = microslip('fastsim2', many, 20, 20);
assert(size(found.fx), [2 2]);
many.creepage_longitudinal = 0.004;
assert(microslip('fastsim2', many, 20, 20).fx, found.fx(2, 2));

% Case files give JSON with the numbers of the file.
text = fileread(fullfile(root, 'examples', 'hertzian_contact.toml'));
result = jsondecode(microslip('solve_case', text));
assert(result.exact.status, 'ok');
assert(result.hertz.a, hertz.a, 1e-12);

% Problems by path have these numbers, too, whether they are read or set.
problem = microslip('read', text);
assert(microslip('solve', problem), 0);
assert(microslip('number', problem, 'fx'), result.exact.fx);
pressure = microslip('field', problem, 'pressure');
assert(sum(sum(pressure .* microslip('field', problem, 'area'))), 80e3, 1e-6 * 80e3);
assert(microslip('get', problem, 'load.normal_force'), 80e3);
assert(microslip('get', problem, 'solution.theory'), 'exact');
assert(numel(microslip('get', problem, 'solution.grid')), 2);
xi = microslip('get', problem, 'motion.creepage_longitudinal');
slopes = microslip('differentiate', problem);
microslip('set', problem, 'motion.creepage_longitudinal', xi + 1e-6);
microslip('solve', problem);
assert(slopes(1, 1), (microslip('number', problem, 'fx') - result.exact.fx) / 1e-6, 0.02 * abs(slopes(1, 1)));
microslip('unset', problem, 'motion.creepage_longitudinal');
assert(microslip('get', problem, 'motion.creepage_longitudinal'), 0);

% Mistakes are errors with the field, and end nothing else.
function refused(words, varargin)
  try
    microslip(varargin{:});
    found = '';
  catch caught
    found = caught.message;
  end
  assert(~isempty(strfind(found, words)), [words ' is not in: ' found]);
end
wrong = contact;
wrong.normal_force = -1;
refused('normal_force = -1', 'fastsim2', wrong);
wrong = contact;
wrong.creep = 1;
refused('contact.creep: unknown', 'fastsim2', wrong);
refused('bodies.rolling_radius must be two numbers', 'hertz', struct('rolling_radius', 1), 1);
refused('must be', 'hertz', setfield(sphere, 'young_modulus', [0 210e9]), 1000);
wrong = contact;
wrong.spin = [1 2 3];
refused('another size', 'fastsim2', wrong);
refused('the first argument must be', 'fastsim');
refused('mx', 'fastsim2', contact, 0, 10);
refused('mx and my must be whole', 'fastsim2', contact, NaN, 10);
refused('a number of cells must be one number', 'fastsim2', contact, [], 10);
refused('normal_force must be one number', 'hertz', sphere, []);
refused('did you mean load.normal_force?', 'set', problem, 'load.normal_forse', 1);
refused('friction.coefficient = -1', 'set', problem, 'friction.coefficient', -1);
refused('is not set', 'get', problem, 'load.approach');
refused('each path needs a value', 'set', problem, 'motion.spin');
refused('a path must be a text', 'set', problem, 1, 2);
refused('"colour"', 'number', problem, 'colour');
refused('of kind', 'create', 'train');
microslip('destroy', problem);
refused('no problem', 'solve', problem);
refused('no problem', 'solve', 0.5);
disp('mex: all is as it should be');
