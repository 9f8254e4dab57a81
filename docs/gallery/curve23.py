# SPDX-License-Identifier: MIT
"""Curve (23) of the PHODCOS paper, (1.5 sin 7.2 t, cos 9 t, exp cos 1.8 t), with derivatives."""

from __future__ import annotations

import numpy as np


def _power_series_exp(f):
    """The Taylor coefficients of exp f from those of f."""
    e = np.zeros_like(f)
    e[0] = np.exp(f[0])
    for k in range(1, len(f)):
        e[k] = sum(j * f[j] * e[k - j] for j in range(1, k + 1)) / k
    return e


def _cosine(rate, t, orders, phase=0.0):
    """Derivatives 0 to orders - 1 of cos(rate t + phase)."""
    return np.array([rate**k * np.cos(rate * t + phase + k * np.pi / 2) for k in range(orders)])


def derivatives(t, orders=5):
    """Position and derivatives at t, (orders, 3)."""
    factorials = np.cumprod(np.maximum(1, np.arange(orders)))
    z = _power_series_exp(_cosine(1.8, t, orders) / factorials) * factorials
    return np.stack([1.5 * _cosine(7.2, t, orders, -np.pi / 2), _cosine(9.0, t, orders), z],
                    axis=-1)


def points(t):
    """Positions at t, (n, 3)."""
    return np.stack([1.5 * np.sin(7.2 * t), np.cos(9 * t), np.exp(np.cos(1.8 * t))], axis=-1)
