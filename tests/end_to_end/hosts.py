"""Variables that keep processes of one machine apart as those of several hosts are."""

APART = {
    "over TCP": (("OMPI_MCA_pml", "ob1"), ("OMPI_MCA_btl", "tcp,self")),
    "without common memory": (("OMPI_MCA_osc", "^sm,ucx"),),
}
"""By what is missing; for Open MPI, others ignore them."""
