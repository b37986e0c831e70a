// Types of what Python sends, written by `python -m hophoop.lab.tables`.

type WholePart = RingPart | DiskPart | PointMassPart | RodPart;

interface RingPart {
  shape: "ring";
  mass: number;
  inner_radius: number;
  outer_radius: number;
}

interface DiskPart {
  shape: "disk";
  mass: number;
  radius: number;
  at: number;
}

interface PointMassPart {
  shape: "point_mass";
  mass: number;
  at: number;
}

interface RodPart {
  shape: "rod";
  mass: number;
  length: number;
  at: number;
  direction: "radial" | "tangential";
}

interface CheckedHoop {
  radius: number;
  mass: number;
  load_fraction: number | null;
  eccentricity: number;
  inertia_ratio: number;
  parts: WholePart[] | null;
}

interface CheckedPlane {
  gravity: number;
  slope: number;
  mu: number | null;
  mu_static: number;
  mu_kinetic: number;
  restitution: number;
  impact_law: "stronge" | "newton" | "poisson";
  painleve: "flight" | "impact";
  rolling_resistance: number;
}

interface CheckedStart {
  x: number;
  height: number;
  angle: number;
  speed: number | null;
  vx: number;
  vy: number;
  omega: number | null;
  slip: number | null;
  mode: "R" | "S" | "K" | "H" | null;
  exact: number[] | null;
}

interface RigidContact {
  model: "rigid";
  max_events: number;
}

interface CompliantContact {
  model: "compliant";
  stiffness: number | null;
  damping: number | null;
  restitution: number | null;
  law: "kelvin-voigt" | "hunt-crossley";
  friction: "tanh" | "linear" | "bristle";
  slip_speed: number | null;
  tangential_stiffness: number | null;
  rtol: number | null;
  max_events: number;
}

interface AllowedRange {
  least: number;
  most: number;
  also: (number | "inf")[];
}

interface SliderInfo {
  path: string;
  label: string;
  symbol: string;
  unit: string;
  help: string;
  least: number;
  most: number;
  step: number;
  logarithmic: boolean;
  degrees: boolean;
  allowed: AllowedRange;
}

interface ChoiceInfo {
  path: string;
  label: string;
  options: [string, string][];
  help: string;
}

interface AxisInfo {
  path: string;
  label: string;
  unit: string;
  degrees: boolean;
  range: [number, number];
  allowed: [number, number];
}

interface ControlsInfo {
  groups: Record<string, SliderInfo[]>;
  choices: ChoiceInfo[];
  gravities: [string, number][];
  map_axes: AxisInfo[];
}

interface Preset {
  key: string;
  group: string;
  title: string;
  text: string;
  query: string;
}

interface Colors {
  modes: Record<string, string>;
  mode_names: Record<string, string>;
  gravity_center: string;
  airborne: string;
  center_speed: string;
  rotation_speed: string;
  kinetic: string;
  potential: string;
  friction_loss: string;
  impact_loss: string;
  normal_force: string;
  friction_force: string;
  limit: string;
}

interface Setup {
  version: string;
  controls: ControlsInfo;
  map_quantities: [string, string][];
  presets: Preset[];
  colors: Colors;
}
