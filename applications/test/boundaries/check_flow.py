"""Compare a solution with an exact flow: check_flow.py case flow bound"""
import re
import sys

import numpy as np

MU = 1.5


def field(case, name, time="1"):
    """Values of the cells in an ascii field."""
    with open(f"{case}/{time}/fluid/{name}") as f:
        text = f.read()
    start = text.index("internalField")
    body = text[start:text.index("boundaryField")]
    numbers = re.search(r"nonuniform[^\n]*\n(\d+)\s*\((.*)\)", body, re.S)
    width = 3 if "vector" in body.split("\n")[0] else 1
    if not numbers:
        value = re.search(r"uniform\s+\(?([^;)]*)", body).group(1).split()
        return np.array([[float(v) for v in value]])
    values = re.sub(r"[()]", " ", numbers.group(2)).split()
    return np.array(values, dtype=float).reshape(-1, width)


def shear(x):
    return np.stack([3*x[:, 2], 0*x[:, 0], 0*x[:, 0]], 1), 0*x[:, 0]


def linear(x):
    gradient = np.array([[0.5, 0.1, -0.2], [0.3, -0.9, 0.4], [-0.6, 0.7, 0.4]])
    return 2*(x - [1, 0.5, 0]) @ gradient.T, 0*x[:, 0]


def couette(x):
    return np.stack([0.5*(1 + x[:, 2]), 0*x[:, 0], 0*x[:, 0]], 1), 0*x[:, 0]


def uniform(x):
    return np.tile([0.3, -0.2, 0.1], (len(x), 1)), 0*x[:, 0]


def table(x):
    return 2*uniform(x)[0], 0*x[:, 0]


def poiseuille(x):
    return (np.stack([2*(1 - x[:, 2]**2), 0*x[:, 0], 0*x[:, 0]], 1),
            -4*MU*x[:, 0])


def duct(x):
    """A square duct of half width 1, flow rate 4: mean velocity 1."""
    y, z = x[:, 1], x[:, 2]
    w, mean = 1 - z**2, 2/3
    for n in range(1, 60, 2):
        k, sign = n*np.pi/2, (-1)**((n - 1)//2)
        w = w - 4*sign*np.exp(k*(np.abs(y) - 1))*(1 + np.exp(-2*k*np.abs(y))) \
            / (1 + np.exp(-2*k))*np.cos(k*z)/k**3
        mean -= 4*np.tanh(k)/k**5
    return np.stack([w/mean, 0*y, 0*y], 1), -2*MU*x[:, 0]/mean


case, flow, bound = sys.argv[1], sys.argv[2], float(sys.argv[3])
x, U, p = field(case, "C"), field(case, "U"), field(case, "p")[:, 0]

if flow in ("shear", "linear", "couette", "uniform", "table"):
    exact, pressure = globals()[flow](x)
    if len(sys.argv) > 4:           # an open end sets the pressure
        pressure = pressure + float(sys.argv[4])
    else:
        p = p - p.mean()
    scale = np.abs(exact).max()
    error = max(np.abs(U - exact).max()/scale,
                np.abs(p - pressure).max()/(MU*scale))
elif flow == "poiseuille":
    # away from the open end
    exact, _ = poiseuille(x)
    away = (x[:, 0] > 1) & (x[:, 0] < x[:, 0].max() - 1.5)
    slope = np.polyfit(x[away, 0], p[away], 1)[0]
    error = max(np.abs(U - exact)[away].max()/2, abs(slope/(-4*MU) - 1))
elif flow == "duct":
    # away from the open end. bound: twice that of Poiseuille's flow on the same
    # cells, as there are walls in two directions
    exact, p0 = duct(x)
    away = (x[:, 0] > 1) & (x[:, 0] < x[:, 0].max() - 1.5)
    slope = np.polyfit(x[away, 0], p[away], 1)[0]
    error = max(np.abs(U - exact)[away].max()/2,
                abs(slope/np.polyfit(x[:, 0], p0, 1)[0] - 1))
elif flow == "driven":
    # pressure difference 8 over length 8: u = (1 - z^2)/(2 mu), mean 1/(3 mu)
    error = abs(U[:, 0].mean()*3*MU - 1)
print(f"{len(x)} cells, error {error:.2e}")
if not error <= bound:
    print(f"error {error:.3g} above {bound:.3g}")
    sys.exit(1)
